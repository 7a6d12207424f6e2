/**
 * AEDAT-1.0 and AEDAT-2.0, the formats of jAER.
 *
 * <p><b>Layout.</b> A text header, each line from a {@code #} to a line feed, then unframed
 * records: AEDAT-2.0 has a 32-bit address and a 32-bit time, AEDAT-1.0 a 16-bit address and a
 * 32-bit time, all big-endian. What an address means depends on the camera: {@link
 * haltere.core.format.internal.aedat2.Dvs128AddressDecoder} and {@link
 * haltere.core.format.internal.aedat2.DavisAddressDecoder} hold the two layouts. The origin is the
 * bottom left pixel.
 *
 * <p><b>Which camera.</b> The header has priority ({@code AEChip:}, {@code HardwareInterface:},
 * {@code Haltere sensor:} of this program), then the addresses of the whole file decide; the reader
 * adds a remark, or rejects them. {@link haltere.core.format.internal.aedat2.AedatSensor} decides.
 *
 * <p><b>Where the header ends.</b> At the line {@code #End Of ASCII Header}, which jAER writes
 * since 2016 and Haltere always. Without it, at the first line that does not begin with {@code #}
 * or is not text; {@link haltere.core.format.internal.aedat2.AedatHeader} distinguishes a record
 * that begins with the byte of {@code #} from a line by the ascending times of the following bytes
 * as records.
 *
 * <p><b>Times.</b> Microseconds of the camera's clock, read as a signed 32-bit number, so that a
 * recording may begin below zero, and extended to 64 bits. A jump back by more than 2<sup>31</sup>
 * is a wrap of the clock and time continues; any other jump back is a restart, a new segment
 * ({@link haltere.core.format.internal.clock.WrappingClock} has the exact rule). An unsigned clock
 * needs no rule of its own: -1 is followed by 0. Times of data that are not read (frames, inertial
 * samples, pixels outside the sensor) do not advance the clock.
 */
package haltere.core.format.internal.aedat2;
