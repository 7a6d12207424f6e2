/** The reader that makes a stream with notifications of what cursors decode. */
package haltere.core.format.internal.reader;
