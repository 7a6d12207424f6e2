/**
 * Prophesee DAT: a text header as that of RAW files, a byte that tells the kind of the events (0 is
 * 2D, 12 is CD) and one that tells their size, then records of 8 bytes, little-endian.
 *
 * <p><b>Times.</b> Microseconds since the recording began or since the camera was started, as the
 * program that decoded the camera's words left them; 32 bits without sign, continued here as 64
 * bits. A jump back by more than 2<sup>31</sup> is a wrap of that clock, any other a restart, a new
 * segment ({@link haltere.core.format.internal.clock.WrappingClock} has the exact rule). Other
 * programs know of no wraps; what we write beyond 32 bits, or before 0, comes back here by them and
 * by a header line that says where the first turn begins.
 *
 * <p><b>Pixels.</b> Rows count from the top in the records and from the bottom in packets. Files of
 * the first sensors state no size (N-CARS): they are taken to come from a sensor of 304x240 pixels
 * unless their events need more.
 */
package haltere.core.format.internal.dat;
