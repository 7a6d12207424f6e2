/**
 * AEDAT-4.0, the format of DV and dv-processing and, since its third version, of jAER.
 *
 * <p><b>Layout.</b> The line {@code #!AER-DAT4.0}, a header (a FlatBuffer that starts with its
 * size) with a description of the streams as XML, packets (number of the stream and size, 32 bits
 * each, then the payload), and in a file that was closed a table of all packets. A payload is a
 * FlatBuffer that starts with its size, compressed as one LZ4 or Zstandard frame or not at all;
 * how, is told by its first bytes, so that a damaged header does no harm. An event has 16 bytes.
 *
 * <p><b>Rows.</b> DV counts from the top, jAER, which says that it was jAER, from the bottom; both
 * are turned to Haltere's upwards. We write as DV does.
 *
 * <p><b>Other streams.</b> Frames, inertial samples and triggers are read if they are wanted; for
 * who reads events each of their packets counts as one of {@link
 * haltere.core.format.Violation#OTHER_DATA}. {@link
 * haltere.core.format.internal.aedat4.Aedat4Format#streams} lists all streams.
 *
 * <p><b>Damage.</b> A file that is cut, or whose writer died, is read up to its last whole packet.
 * Behind a damaged packet the next is found by its header, or, where that is damaged too, by
 * looking for the first bytes of a payload. No size in a file makes memory grow: payloads are
 * decompressed piece by piece, Zstandard's of more than 4 MiB with a window of at most 32 MiB.
 *
 * <p><b>What a time means.</b> Microseconds as 64 bits; DV adds the time of the host's clock, so
 * they count from 1970.
 */
package haltere.core.format.internal.aedat4;
