package haltere.filters.wing.stroke;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import java.util.Optional;

/**
 * Estimates the stroke of one edge of a wing from the edge's own events. Times in microseconds,
 * angles in radians.
 *
 * <p>Thread rule: one thread at a time.
 */
abstract class EdgeEstimator {
  /** Events taken in since the launch. */
  long taken;

  /** Time of the last event, of the launch before the first. */
  long lastEventUs;

  /** Angle that was expected of the last event. */
  double expected;

  /** Begins with a stroke. */
  void launch(long atUs, StrokeSeed seed) {
    taken = 0;
    lastEventUs = atUs;
  }

  /**
   * Takes an event.
   *
   * @return whether it ends a beat of the edge
   */
  abstract boolean event(long timeUs, double measured);

  abstract double angle(double atUs);

  abstract double centre();

  abstract double amplitude();

  /** Phase at a time, not wrapped. */
  abstract double phase(double atUs);

  /** Angular frequency, radians a second. */
  abstract double omega();

  /** Smallest and largest angle of the last beat. */
  abstract double least();

  abstract double most();

  /** Variance of the angle and of the angular frequency, NaN where the method gives none. */
  double angleVariance(double atUs) {
    return Double.NaN;
  }

  double omegaVariance() {
    return Double.NaN;
  }

  double nis() {
    return Double.NaN;
  }

  abstract void apply(WingTrackerSettings settings);

  abstract boolean isLost(long nowUs);

  Optional<WingFilterState> filter() {
    return Optional.empty();
  }

  void edit(WingFilterEdit edit) {
    throw new IllegalArgumentException("the running average has no filter to change");
  }
}
