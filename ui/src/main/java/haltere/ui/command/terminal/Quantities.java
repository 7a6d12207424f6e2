package haltere.ui.command.terminal;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Formats numbers for users, independently of the locale. */
public final class Quantities {
  private Quantities() {}

  /** A whole number with commas, such as 1,234,567. */
  public static String count(long value) {
    return text("%,d", value);
  }

  /** A rate of events a second in a unit that suits it, such as 2.50 Mev/s. */
  public static String rate(double eventsPerSecond) {
    return eventsPerSecond >= 1e6
        ? text("%.2f Mev/s", eventsPerSecond / 1e6)
        : eventsPerSecond >= 1e3
            ? text("%.2f kev/s", eventsPerSecond / 1e3)
            : text("%.2f ev/s", eventsPerSecond);
  }

  /** A time in microseconds as seconds, such as 1.500000 s. */
  public static String seconds(long microseconds) {
    return text("%.6f s", microseconds / 1e6);
  }

  /** A count with its noun, which has an s unless it is one. */
  public static String counted(long count, String noun) {
    return count(count) + " " + noun + (count == 1 ? "" : "s");
  }

  /** So many events, such as 1 event or 1,200 events. */
  public static String events(long count) {
    return counted(count, "event");
  }

  /** Lines of a table whose columns but the last are as wide as their widest cell. */
  public static List<String> table(String indent, List<List<String>> rows) {
    Map<Integer, Integer> widths = new HashMap<>();
    for (List<String> row : rows) {
      for (int i = 0; i < row.size() - 1; i++) {
        widths.merge(i, row.get(i).length(), Math::max);
      }
    }
    return rows.stream()
        .map(
            row ->
                IntStream.range(0, row.size())
                    .mapToObj(i -> text("%-" + widths.getOrDefault(i, 1) + "s", row.get(i)))
                    .collect(Collectors.joining("  ", indent, ""))
                    .stripTrailing())
        .toList();
  }

  /** Words and numbers by a format of {@link String#format}. */
  public static String text(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }
}
