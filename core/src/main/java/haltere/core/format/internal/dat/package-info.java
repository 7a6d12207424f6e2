/**
 * Prophesee DAT: a text header as that of RAW files, a byte for the kind of the events (0 is 2D, 12
 * is CD) and one for their size, then records of 8 bytes, little-endian.
 *
 * <p><b>Times.</b> Microseconds since the recording began or since the camera was started, as
 * written by the decoding program; unsigned 32 bits, extended to 64 bits. A jump back by more than
 * 2<sup>31</sup> is a wrap of that clock, any other a restart, a new segment ({@link
 * haltere.core.format.internal.clock.WrappingClock} has the exact rule). Other programs do not
 * count wraps; times beyond 32 bits, or before 0, are restored from them and from a header line
 * with the start of the first period.
 *
 * <p><b>Pixels.</b> Rows count from the top in the records and from the bottom in packets. Files of
 * the first sensors state no size (N-CARS): a sensor of 304x240 pixels is assumed unless their
 * events need more.
 */
package haltere.core.format.internal.dat;
