package haltere.filters.wing;

import java.util.List;

/**
 * Estimates the stroke of one wing from its events. Times never go back.
 *
 * <p>Thread rule: one thread at a time.
 */
interface SideEstimator {
  /**
   * Takes an event of the wing's side that lies in the region of interest; the frame has just
   * looked at it.
   *
   * @return whether it was taken in
   */
  boolean event(long timeUs, boolean on);

  /** Brings the estimate to a time before which no event comes any more. */
  void advance(long timeUs);

  /** Stroke angle at the time of the last {@link #advance}. */
  double angle();

  /** Stroke angle of an edge, 0 leading, 1 trailing. */
  double edgeAngle(int edge);

  double centre();

  double amplitude();

  /** Phase in [0, 2 pi), 0 where the wing passes its centre towards the tail. */
  double phase();

  /** Phase at a time near the present one. */
  double phaseAt(double timeUs);

  double frequencyHz();

  /** Standard deviation of the angle, NaN if unknown. */
  double sdAngle();

  /** Standard deviation of the frequency, NaN if unknown. */
  double sdFrequencyHz();

  /** Mean normalised innovation squared of late, NaN if unknown. */
  double nis();

  /** Events taken in of an edge, 0 leading, 1 trailing. */
  long events(int edge);

  /** What was expected of the event that was taken in last, before latency is taken out. */
  double expected();

  /** The Kalman filters, of the wing or of its edges; none for a method without. */
  default List<WingFilterState> filters() {
    return List.of();
  }

  /**
   * Changes a number of a filter.
   *
   * @throws IllegalArgumentException with a line for a person if it cannot be that number
   */
  default void edit(WingFilterEdit edit) {
    throw new IllegalArgumentException("the running average has no filter to change");
  }

  /** The stroke as it is now, for another estimator to begin with. */
  StrokeSeed seed();

  /** Takes settings that do not change what the estimator is. */
  void apply(WingTrackerSettings changed);

  /** Whether the wing is no longer where the estimate says. */
  boolean isLost(long timeUs);
}
