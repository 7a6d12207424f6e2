/**
 * Events as text, as array programs and spreadsheets read them. Written as {@code t_us,x,y,on};
 * read with the columns in any order.
 *
 * <p><b>Times.</b> Whatever the writer of the text meant: a name such as {@code t_us}, {@code
 * time_s} or {@code timestamp_ns} tells the unit; without one, times with decimals are seconds,
 * whole numbers microseconds, and whole numbers of 17 digits nanoseconds. Numbers are taken
 * exactly, never as 32-bit floating-point ones; a time between two microseconds goes to the nearer
 * one. There are no wraps; a time that goes back starts a new segment.
 *
 * <p><b>Columns.</b> Separated by commas, semicolons, tabs or spaces. Named by a first line, which
 * may be a comment, or found out: the polarity has the values 0 and 1, or -1 and 1, the time never
 * falls, the column comes before the row. A first line of two numbers is the sensor's width and
 * height. Without a column of polarities all events are ON.
 *
 * <p><b>Pixels.</b> Rows are taken to count from the top, unless the user says otherwise. The size
 * is that of the first line or the user's, else the smallest usual one that holds the events.
 */
package haltere.core.format.internal.csv;
