/**
 * Recordings: one entry point for all file formats, which are services. Readers are event sources
 * with seeking and metadata; writers are sinks.
 */
package haltere.core.format;
