package haltere.filters.wing.internal.stroke;

import java.util.List;
import java.util.stream.IntStream;

/** Names and units of the entries of the filter of a wing, for display. */
final class FilterNumbers {
  /** Name, unit and unit of the density of the process noise of each entry before the harmonics. */
  private static final String[][] ENTRIES = {
    {"centre", "rad", "rad\u00b2/s"},
    {"amplitude", "rad", "rad\u00b2/s"},
    {"phase", "rad", "rad\u00b2/s"},
    {"angular frequency", "rad/s", "rad\u00b2/s\u00b3"},
    {"half width", "rad", "rad\u00b2/s"},
    {"lag of ON events", "s", "s"},
    {"rate of angular frequency", "rad/s\u00b2", "rad\u00b2/s\u2075"}
  };

  static final int NAMES = 0;
  static final int UNITS = 1;
  static final int DENSITY_UNITS = 2;

  private FilterNumbers() {}

  /** Names or units of the entries of a filter's state. */
  static List<String> of(int column, int size) {
    return IntStream.range(0, size)
        .mapToObj(i -> i < ENTRIES.length ? ENTRIES[i][column] : harmonic(column, i))
        .toList();
  }

  private static String harmonic(int column, int entry) {
    int i = entry - ENTRIES.length;
    return column == NAMES
        ? (i % 2 == 0 ? "cosine" : "sine") + " of harmonic " + (i / 2 + 2)
        : ENTRIES[0][column];
  }
}
