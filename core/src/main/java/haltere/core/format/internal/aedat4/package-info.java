/**
 * AEDAT-4.0, the format of DV and dv-processing and, since its third version, of jAER.
 *
 * <p><b>Layout.</b> The line {@code #!AER-DAT4.0}, a header (a size-prefixed FlatBuffer) with a
 * description of the streams as XML, packets (number of the stream and size, 32 bits each, then the
 * payload), and in a closed file a table of all packets. A payload is a size-prefixed FlatBuffer,
 * compressed as one LZ4 or Zstandard frame or uncompressed; its first bytes show which, so that a
 * damaged header does no harm. An event has 16 bytes.
 *
 * <p><b>Rows.</b> DV counts from the top, jAER, detected by its name, from the bottom; both are
 * converted to Haltere's bottom origin. Haltere writes as DV does.
 *
 * <p><b>Other streams.</b> Frames, inertial samples and triggers are read on request; otherwise
 * each of their packets counts as one of {@link haltere.core.format.Violation#OTHER_DATA}. {@link
 * haltere.core.format.internal.aedat4.Aedat4Format#streams} lists all streams.
 *
 * <p><b>Damage.</b> A truncated file, or one of a killed writer, is read up to its last complete
 * packet. After a damaged packet the next is found by its header or, if that is damaged too, by the
 * first bytes of a payload. Memory is independent of stated sizes: payloads are decompressed piece
 * by piece, Zstandard frames of more than 4 MiB with a window of at most 32 MiB.
 *
 * <p><b>Times.</b> Microseconds as 64 bits; DV adds the time of the host's clock, so that they
 * count from 1970.
 */
package haltere.core.format.internal.aedat4;
