/**
 * Events as text, as array programs and spreadsheets read them. Written as {@code t_us,x,y,on};
 * read with the columns in any order.
 *
 * <p><b>Times.</b> The unit is that of a name such as {@code t_us}, {@code time_s} or {@code
 * timestamp_ns}; without one, times with decimals are seconds, whole numbers microseconds, and
 * whole numbers of 17 digits nanoseconds. Numbers are read exactly, not as 32-bit floating-point
 * ones; times are rounded to the nearest microsecond. There are no wraps; a time that goes back
 * starts a new segment.
 *
 * <p><b>Columns.</b> Separated by commas, semicolons, tabs or spaces. Named by a first line, which
 * may be a comment, or detected: the polarity has the values 0 and 1, or -1 and 1, the time never
 * falls, the column comes before the row. A first line of two numbers is the sensor's width and
 * height. Without a column of polarities all events are ON.
 *
 * <p><b>Pixels.</b> Rows count from the top by default. The size is that of the first line or the
 * user's options, else the smallest usual one that holds the events.
 */
package haltere.core.format.internal.csv;
