package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import java.util.List;

/**
 * Estimates the stroke of one wing from its events, whose times ascend. Stroke angles are radians
 * in the {@link StrokeFrame} of the wing.
 */
public interface SideEstimator {
  /** Number of the leading edge (OFF events). */
  int LEADING = 0;

  /** Number of the trailing edge (ON events). */
  int TRAILING = 1;

  /** Number of the wing as a whole. */
  int WING = 2;

  /**
   * Starts with a stroke.
   *
   * @param atUs microseconds
   * @param seed the stroke
   */
  void launch(long atUs, StrokeSeed seed);

  /**
   * Processes an event in the region of interest, for which the frame was just asked.
   *
   * @param timeUs microseconds
   * @param on its polarity
   * @return expected stroke angle, before the latency is removed; NaN if the event was rejected
   */
  double event(long timeUs, boolean on);

  /**
   * Predicts the estimate to a time; later events are not earlier than this.
   *
   * @param timeUs microseconds
   */
  void advance(long timeUs);

  /**
   * The estimate of an edge or of the wing at the time of the last {@link #advance}.
   *
   * @param part {@link #LEADING}, {@link #TRAILING} or {@link #WING}
   * @return standard deviations are NaN if the method has none
   */
  WingEstimate estimate(int part);

  /**
   * Angles of both edges over the beat after the last {@link #advance}.
   *
   * @param steps number of angles, at even steps of the phase from now on
   * @return angles of the {@link #LEADING} and the {@link #TRAILING} edge, radians, not wrapped
   */
  double[][] beat(int steps);

  /** {@return the present Kalman filters of the wing or of its edges, if there are any} */
  default List<WingFilterState> filters() {
    return List.of();
  }

  /**
   * Changes a number of a filter.
   *
   * @param edit the change
   * @throws IllegalArgumentException if the value is not possible
   */
  void edit(WingFilterEdit edit);

  /** {@return the present stroke, to start another estimator} */
  StrokeSeed seed();

  /**
   * Applies settings that need no other estimator.
   *
   * @param changed valid settings
   */
  void apply(WingTrackerSettings changed);

  /**
   * Whether lock is lost.
   *
   * @param timeUs now, microseconds
   * @return true if the wing must be searched again
   */
  boolean isLost(long timeUs);
}
