package haltere.core.format.internal.decoding;

import java.util.Locale;
import java.util.OptionalInt;

/** What a column of plain events holds, by the names that the programs of the field give it. */
public enum EventColumn {
  /** When. */
  TIME,
  /** Column of the pixel. */
  X,
  /** Row of the pixel. */
  Y,
  /** Whether the light rose or fell. */
  POLARITY,
  /** Something else. */
  OTHER;

  /**
   * The column that a name stands for.
   *
   * @param name as a header gives it, with or without a unit
   * @return {@link #OTHER} if it is none of ours
   */
  public static EventColumn named(String name) {
    String plain = words(name).replaceAll("^_|_$", "");
    return switch (plain.replaceAll("_(us|ns|ms|s|px|sec|seconds|microseconds|nanoseconds)$", "")) {
      case "t", "ts", "time", "timestamp", "timestamps", "times" -> TIME;
      case "x", "xs", "col", "column" -> X;
      case "y", "ys", "row" -> Y;
      case "p", "ps", "pol", "polarity", "polarities", "on", "sign" -> POLARITY;
      default -> OTHER;
    };
  }

  /**
   * The unit that a name states for times, as the power of ten that makes microseconds of it: 0 for
   * microseconds, 6 for seconds.
   *
   * @param name as a header gives it
   * @return the power, or empty if the name states no unit
   */
  public static OptionalInt timeScale(String name) {
    String unit = words(name) + "_";
    if (unit.contains("_us_") || unit.contains("_micros")) {
      return OptionalInt.of(0);
    }
    if (unit.contains("_ns_") || unit.contains("_nanos")) {
      return OptionalInt.of(-3);
    }
    if (unit.contains("_ms_") || unit.contains("_millis")) {
      return OptionalInt.of(3);
    }
    if (unit.contains("_s_") || unit.contains("_sec")) {
      return OptionalInt.of(6);
    }
    return OptionalInt.empty();
  }

  private static String words(String name) {
    return name.toLowerCase(Locale.ROOT).replaceAll("[^a-z]+", "_");
  }
}
