/**
 * Recordings: one entry point for all file formats, which are named services. Readers are event
 * sources that can seek and have metadata, writers are sinks.
 */
package haltere.core.format;
