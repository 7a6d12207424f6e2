/**
 * NumPy: events as arrays, in a zip file ({@code .npz}) or alone ({@code .npy}).
 *
 * <p><b>Times.</b> Whatever the writer of the arrays meant. A name such as {@code t_us} or {@code
 * timestamp_ns} tells the unit; without one, times with decimals are seconds, whole numbers
 * microseconds, and whole numbers of 18 digits nanoseconds. 32-bit floating-point times are no more
 * exact than they are. There are no wraps; a time that goes back starts a new segment.
 *
 * <p><b>Which arrays.</b> Lists named as columns of events are ({@code t}, {@code x}, {@code y},
 * {@code p} and their like), side by side, or the fields of one structured list; tables are not
 * read. What we write has the sensor's size and which way its rows count too. Otherwise rows are
 * taken to count from the top.
 *
 * <p><b>Packed arrays</b> ({@code numpy.savez_compressed}) can only be read from their start, so
 * that seeking back in them takes as long as reading up to there.
 */
package haltere.core.format.internal.npz;
