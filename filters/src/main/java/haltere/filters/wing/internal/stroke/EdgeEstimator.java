package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import java.util.Optional;

/** Estimates the stroke of one edge from its events. Microseconds, radians. */
abstract class EdgeEstimator {
  /** Events used since the launch. */
  long taken;

  /** Time of the last event, of the launch before the first. */
  long lastEventUs;

  /** Expected angle of the last event. */
  double expected;

  /** Mean angle of a beat, half of peak to peak, and angular frequency in radians a second. */
  double centre;

  double amplitude;
  double omega;

  /** Smallest and largest angle of the last beat. */
  double min;

  double max;

  /** Normalised innovation squared of the last event, NaN if the method has none. */
  double nis = Double.NaN;

  void launch(long atUs, StrokeSeed seed) {
    taken = 0;
    lastEventUs = atUs;
    centre = seed.centre();
    amplitude = seed.amplitude();
    omega = seed.omega();
  }

  /** Processes an event; returns whether it ends a beat of the edge. */
  abstract boolean event(long timeUs, double measured);

  abstract double angle(double atUs);

  /** Phase at a time, not wrapped. */
  abstract double phase(double atUs);

  /** Variance of the angle, NaN if the method has none. */
  double angleVariance(double atUs) {
    return Double.NaN;
  }

  /** Variance of the angular frequency, NaN if the method has none. */
  double omegaVariance() {
    return Double.NaN;
  }

  abstract void apply(WingTrackerSettings settings);

  abstract boolean isLost(long nowUs);

  Optional<WingFilterState> filter() {
    return Optional.empty();
  }

  void edit(WingFilterEdit edit) {
    throw new IllegalArgumentException("the running average has no filter to edit");
  }
}
