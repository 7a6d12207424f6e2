/**
 * AEDAT-1.0 and AEDAT-2.0, the formats of jAER.
 *
 * <p><b>Layout.</b> A text header, each line from a {@code #} to a line feed, then records without
 * any frame: AEDAT-2.0 has a 32-bit address and a 32-bit time, AEDAT-1.0 a 16-bit address and a
 * 32-bit time, all big-endian. What an address means depends on the camera: {@link
 * haltere.core.format.internal.aedat2.Dvs128AddressDecoder} and {@link
 * haltere.core.format.internal.aedat2.DavisAddressDecoder} hold the two layouts. The origin is the
 * bottom left pixel.
 *
 * <p><b>Which camera.</b> The header's word comes first ({@code AEChip:}, {@code
 * HardwareInterface:}, our own {@code Haltere sensor:}), then the addresses of the whole file; the
 * reader says so in a remark, or refuses them. {@link
 * haltere.core.format.internal.aedat2.AedatSensor} decides.
 *
 * <p><b>Where the header ends.</b> At the line {@code #End Of ASCII Header}, which jAER writes
 * since 2016 and we always do. Without it, at the first line that does not begin with {@code #} or
 * is no text; {@link haltere.core.format.internal.aedat2.AedatHeader} tells a record that happens
 * to begin with the byte of {@code #} from a line by the clock that the following bytes make when
 * they are read as records.
 *
 * <p><b>What a time means.</b> Microseconds of the camera's clock, read as a signed 32-bit number,
 * so a recording may begin below zero, and continued here as 64 bits. A jump back by more than
 * 2<sup>31</sup> is a wrap of the clock and time continues; any other jump back is a restart, a new
 * segment ({@link haltere.core.format.internal.clock.WrappingClock} has the exact rule). A clock
 * that goes through all 2<sup>32</sup> values, like one of a camera that counts without sign, needs
 * no rule of its own: -1 is followed by 0. Times in the file of events that are not read (frames,
 * inertial samples, pixels outside of the sensor) do not move the clock.
 */
package haltere.core.format.internal.aedat2;
