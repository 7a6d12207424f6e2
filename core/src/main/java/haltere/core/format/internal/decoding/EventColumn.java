package haltere.core.format.internal.decoding;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.regex.Pattern;

/** Columns of plain events, by the names in usual programs. */
public enum EventColumn {
  /** Time of the event. */
  TIME,
  /** Column of the pixel. */
  X,
  /** Row of the pixel. */
  Y,
  /** Polarity of the event. */
  POLARITY,
  /** Any other column. */
  OTHER;

  /** Year 1973 in nanoseconds since 1970; as microseconds, more than three thousand years. */
  private static final double MIN_NS = 1e17;

  private static final Pattern NO_LETTERS = Pattern.compile("[^\\p{L}]+");
  private static final Pattern MICRO = Pattern.compile("[\u00b5\u03bc]");
  private static final Pattern EDGES = Pattern.compile("^_|_$");
  private static final Pattern UNIT =
      Pattern.compile(
          "_(us|ns|ms|s|px|usec|msec|sec|seconds|milliseconds|microseconds|nanoseconds|pixels?)$");

  /**
   * The column of a name.
   *
   * @param name as in a header, with or without a unit
   * @return {@link #OTHER} for an unknown name
   */
  public static EventColumn named(String name) {
    String plain = EDGES.matcher(words(name)).replaceAll("");
    return switch (UNIT.matcher(plain).replaceAll("")) {
      case "t", "ts", "time", "timestamp", "timestamps", "times", "time_stamp" -> TIME;
      case "x", "xs", "col", "column", "x_addr", "xaddr", "x_pos", "x_coordinate" -> X;
      case "y", "ys", "row", "y_addr", "yaddr", "y_pos", "y_coordinate" -> Y;
      case "p", "ps", "pol", "pols", "polarity", "polarities" -> POLARITY;
      case "on", "is_on", "on_off", "sign", "is_increase" -> POLARITY;
      default -> OTHER;
    };
  }

  /**
   * Whether columns are events.
   *
   * @param columns their contents
   * @return whether time, column and row of the pixel are among them
   */
  public static boolean areEvents(Collection<EventColumn> columns) {
    return columns.containsAll(List.of(TIME, X, Y));
  }

  /**
   * The time unit in a name, as its power of ten in microseconds: 0 for microseconds, 6 for
   * seconds.
   *
   * @param name as in a header
   * @return the power, or empty if the name has no unit
   */
  public static OptionalInt timeScale(String name) {
    String unit = words(name) + "_";
    if (unit.contains("_us_") || unit.contains("_usec") || unit.contains("_micros")) {
      return OptionalInt.of(0);
    }
    if (unit.contains("_ns_") || unit.contains("_nanos")) {
      return OptionalInt.of(-3);
    }
    if (unit.contains("_ms_") || unit.contains("_msec") || unit.contains("_millis")) {
      return OptionalInt.of(3);
    }
    if (unit.contains("_s_") || unit.contains("_sec")) {
      return OptionalInt.of(6);
    }
    return OptionalInt.empty();
  }

  /**
   * The time unit of numbers, as for a name: times with decimals are seconds, whole ones
   * microseconds, or nanoseconds since 1970.
   *
   * @param fractions whether some have decimals
   * @param largest the largest magnitude
   * @return the power
   */
  public static int timeScale(boolean fractions, double largest) {
    return fractions ? 6 : largest >= MIN_NS ? -3 : 0;
  }

  private static String words(String name) {
    String letters = MICRO.matcher(name.toLowerCase(Locale.ROOT)).replaceAll("u");
    return NO_LETTERS.matcher(letters).replaceAll("_");
  }
}
