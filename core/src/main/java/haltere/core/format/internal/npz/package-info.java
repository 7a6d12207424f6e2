/**
 * NumPy: events as arrays, in a zip file ({@code .npz}) or alone ({@code .npy}).
 *
 * <p><b>Times.</b> The unit is that of a name such as {@code t_us} or {@code timestamp_ns}; without
 * one, times with decimals are seconds, whole numbers microseconds, and whole numbers of 18 digits
 * nanoseconds. 32-bit floating-point times keep their limited precision. There are no wraps; a time
 * that goes back starts a new segment.
 *
 * <p><b>Which arrays.</b> Lists with usual names of event columns ({@code t}, {@code x}, {@code y},
 * {@code p} and similar), separate or as the fields of one structured list; tables are not read.
 * Files of Haltere also have the sensor's size and the origin of rows. Otherwise rows count from
 * the top.
 *
 * <p><b>Compressed arrays</b> ({@code numpy.savez_compressed}) can only be read from their start,
 * so that seeking back takes as long as reading up to the position.
 */
package haltere.core.format.internal.npz;
