/**
 * Recordings: one way in for every file format, each format a named service; readers are event
 * sources that can seek and say what they know, writers are sinks.
 */
package haltere.core.format;
