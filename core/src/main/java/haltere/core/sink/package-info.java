/** Destinations of packets and results: files, tables, a mailbox for the screen. */
package haltere.core.sink;
