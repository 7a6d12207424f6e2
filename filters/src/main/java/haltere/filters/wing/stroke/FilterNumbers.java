package haltere.filters.wing.stroke;

import java.util.ArrayList;
import java.util.List;

/** Names and units of the numbers of a wing's filter, for a person. */
final class FilterNumbers {
  private static final List<String> NAMES =
      List.of(
          "centre",
          "amplitude",
          "phase",
          "angular frequency",
          "half width",
          "lag of ON events",
          "rate of angular frequency");
  private static final List<String> UNITS =
      List.of("rad", "rad", "rad", "rad/s", "rad", "s", "rad/s\u00b2");
  private static final List<String> DENSITY_UNITS =
      List.of(
          "rad\u00b2/s",
          "rad\u00b2/s",
          "rad\u00b2/s",
          "rad\u00b2/s\u00b3",
          "rad\u00b2/s",
          "s",
          "rad\u00b2/s\u2075");

  private FilterNumbers() {}

  static List<String> names(int harmonics) {
    List<String> names = new ArrayList<>(NAMES);
    for (int k = 2; k <= harmonics; k++) {
      names.add("cosine of harmonic " + k);
      names.add("sine of harmonic " + k);
    }
    return names;
  }

  static List<String> units(int harmonics) {
    return withSeries(UNITS, harmonics);
  }

  /** Units of the density of process noise. */
  static List<String> densityUnits(int harmonics) {
    return withSeries(DENSITY_UNITS, harmonics);
  }

  private static List<String> withSeries(List<String> first, int harmonics) {
    List<String> units = new ArrayList<>(first);
    for (int i = 0; i < 2 * (harmonics - 1); i++) {
      units.add(first.get(0));
    }
    return units;
  }
}
