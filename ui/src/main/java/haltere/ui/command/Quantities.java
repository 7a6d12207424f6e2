package haltere.ui.command;

import java.util.Locale;

/** Numbers for a person: the same in every locale. */
final class Quantities {
  private Quantities() {}

  static String count(long value) {
    return String.format(Locale.ROOT, "%,d", value);
  }

  static String rate(double eventsPerSecond) {
    if (eventsPerSecond >= 1e6) {
      return String.format(Locale.ROOT, "%.2f Mev/s", eventsPerSecond / 1e6);
    }
    if (eventsPerSecond >= 1e3) {
      return String.format(Locale.ROOT, "%.2f kev/s", eventsPerSecond / 1e3);
    }
    return String.format(Locale.ROOT, "%.2f ev/s", eventsPerSecond);
  }

  static String seconds(long microseconds) {
    return String.format(Locale.ROOT, "%.6f s", microseconds / 1e6);
  }

  static String events(long count) {
    return count(count) + (count == 1 ? " event" : " events");
  }
}
