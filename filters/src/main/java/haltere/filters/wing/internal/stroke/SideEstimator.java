package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import java.util.List;

/**
 * Estimates the stroke of one wing from its events. Times never go back. Angles in radians: stroke
 * angles are measured in the wing's {@link StrokeFrame}.
 */
public interface SideEstimator {
  /** Number of the leading edge (OFF events). */
  int LEADING = 0;

  /** Number of the trailing edge (ON events). */
  int TRAILING = 1;

  /** Number of the wing as a whole. */
  int WING = 2;

  /**
   * Begins with a stroke.
   *
   * @param atUs when, microseconds
   * @param seed the stroke
   */
  void launch(long atUs, StrokeSeed seed);

  /**
   * Takes an event of the wing's side that lies in the region of interest; the frame has just
   * looked at it.
   *
   * @param timeUs when, microseconds
   * @param on its polarity
   * @return stroke angle that was expected, before latency is taken out; NaN if it was refused
   */
  double event(long timeUs, boolean on);

  /**
   * Brings the estimate to a time before which no event comes any more.
   *
   * @param timeUs microseconds
   */
  void advance(long timeUs);

  /**
   * The estimate of an edge or of the wing at the time of the last {@link #advance}.
   *
   * @param part {@link #LEADING}, {@link #TRAILING} or {@link #WING}
   * @return standard deviations are NaN where the method gives none
   */
  WingEstimate estimate(int part);

  /**
   * The way of both edges over the beat that follows the last {@link #advance}.
   *
   * @param steps how many angles, at even steps of the phase, the first one of now
   * @return stroke angles of the {@link #LEADING} and the {@link #TRAILING} edge, radians, not
   *     wrapped
   */
  double[][] beat(int steps);

  /** {@return the Kalman filters of the wing or of its edges as they are now; none without} */
  default List<WingFilterState> filters() {
    return List.of();
  }

  /**
   * Changes a number of a filter.
   *
   * @param edit which number
   * @throws IllegalArgumentException with a line for a person if it cannot be that number
   */
  void edit(WingFilterEdit edit);

  /** {@return the stroke as it is now, for another estimator to begin with} */
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
