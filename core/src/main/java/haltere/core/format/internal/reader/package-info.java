/** The reader that makes a stream with notifications from the events of cursors. */
package haltere.core.format.internal.reader;
