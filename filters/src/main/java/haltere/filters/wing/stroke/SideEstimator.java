package haltere.filters.wing.stroke;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import java.util.List;

/**
 * Estimates the stroke of one wing from its events. Times never go back. Angles in radians: stroke
 * angles are measured in the wing's {@link StrokeFrame}.
 *
 * <p>Thread rule: one thread at a time.
 */
public interface SideEstimator {
  /**
   * Takes an event of the wing's side that lies in the region of interest; the frame has just
   * looked at it.
   *
   * @param timeUs when, microseconds
   * @param on its polarity
   * @return whether it was taken in
   */
  boolean event(long timeUs, boolean on);

  /**
   * Brings the estimate to a time before which no event comes any more.
   *
   * @param timeUs microseconds
   */
  void advance(long timeUs);

  /**
   * Where the wing is.
   *
   * @return stroke angle at the time of the last {@link #advance}
   */
  double angle();

  /**
   * Where an edge of the wing is.
   *
   * @param edge 0 leading, 1 trailing
   * @return its stroke angle at the time of the last {@link #advance}
   */
  double edgeAngle(int edge);

  /**
   * What the wing beats about.
   *
   * @return mean stroke angle
   */
  double centre();

  /**
   * How far the wing beats.
   *
   * @return half of peak to peak
   */
  double amplitude();

  /**
   * Where in its beat the wing is.
   *
   * @return in [0, 2 pi), 0 where the wing passes its centre towards the tail
   */
  double phase();

  /**
   * The phase at a time near the present one.
   *
   * @param timeUs microseconds
   * @return the phase, not wrapped
   */
  double phaseAt(double timeUs);

  /**
   * How often the wing beats.
   *
   * @return hertz
   */
  double frequencyHz();

  /**
   * How sure the angle is.
   *
   * @return standard deviation, NaN if unknown
   */
  double sdAngle();

  /**
   * How sure the frequency is.
   *
   * @return standard deviation, hertz, NaN if unknown
   */
  double sdFrequencyHz();

  /**
   * How well the estimate knows its own errors.
   *
   * @return mean normalised innovation squared of late, NaN if unknown
   */
  double nis();

  /**
   * Counts what was taken in.
   *
   * @param edge 0 leading, 1 trailing
   * @return events of that edge
   */
  long events(int edge);

  /**
   * What was expected of the event that was taken in last.
   *
   * @return stroke angle, before latency is taken out
   */
  double expected();

  /**
   * The Kalman filters, of the wing or of its edges.
   *
   * @return as they are now; none for a method without
   */
  default List<WingFilterState> filters() {
    return List.of();
  }

  /**
   * Changes a number of a filter.
   *
   * @param edit which number
   * @throws IllegalArgumentException with a line for a person if it cannot be that number
   */
  default void edit(WingFilterEdit edit) {
    throw new IllegalArgumentException("the running average has no filter to change");
  }

  /**
   * The stroke as it is now.
   *
   * @return for another estimator to begin with
   */
  StrokeSeed seed();

  /**
   * Takes settings that do not change what the estimator is.
   *
   * @param changed valid settings
   */
  void apply(WingTrackerSettings changed);

  /**
   * Whether the wing is no longer where the estimate says.
   *
   * @param timeUs now, microseconds
   * @return true if the wing has to be searched for
   */
  boolean isLost(long timeUs);
}
