package haltere.filters.wing.stroke;

import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingSide;
import java.util.ArrayList;
import java.util.List;

/** The numbers of a wing's filter, for a person. */
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

  private FilterNumbers() {}

  /** The filter of a wing as it is now, with the density of its process noise in steady flight. */
  static WingFilterState of(
      WingSide side, StrokeEkf filter, double[] q, WingEventNoise noise, long events) {
    List<String> names = new ArrayList<>(NAMES);
    List<String> units = new ArrayList<>(UNITS);
    for (int k = 2; k <= filter.harmonics; k++) {
      names.add("cosine of harmonic " + k);
      names.add("sine of harmonic " + k);
      units.add("rad");
      units.add("rad");
    }
    return new WingFilterState(
        WingPart.wing(side.ordinal()),
        names,
        units,
        filter.x,
        filter.belief.covariance().data,
        q,
        noise.present(),
        noise.fixed() == 0,
        noise.nis(),
        events);
  }
}
