package haltere.filters.cluster;

/**
 * The visible clusters of a {@link ClusterTracker} at one time, by index from 0, in the order of
 * their births. A view without memory of its own: nothing is allocated, and it is valid only during
 * the call that hands it out.
 *
 * <p>For each cluster there is the tracker's own estimate (position, velocity), which is smoothed
 * and so correlated in time, and the raw measurement: the mean place of the events that it has
 * taken since the last reading, at their mean time. The measurements of two readings have no event
 * in common: their errors are independent, which is what a Kalman filter asks for.
 *
 * <p>Thread rule: only within the call.
 */
public interface ClusterReadings {
  /**
   * How many visible clusters there are.
   *
   * @return at least 0
   */
  int count();

  /**
   * Identity of a cluster.
   *
   * @param index of the cluster
   * @return from 1, never given out twice by a tracker
   */
  int id(int index);

  /**
   * Column of the centre at the time of the reading, as the tracker estimates it.
   *
   * @param index of the cluster
   * @return pixels
   */
  double x(int index);

  /**
   * Row of the centre at the time of the reading, as the tracker estimates it.
   *
   * @param index of the cluster
   * @return pixels
   */
  double y(int index);

  /**
   * Velocity to the right, as the tracker estimates it.
   *
   * @param index of the cluster
   * @return pixels a second
   */
  double vx(int index);

  /**
   * Velocity upwards, as the tracker estimates it.
   *
   * @param index of the cluster
   * @return pixels a second
   */
  double vy(int index);

  /**
   * Events in the measurement: those that the cluster has taken since the last reading, at the
   * first one since its birth. Where clusters overlap an event is shared among them by how likely
   * it is each one's, so this need not be a whole number.
   *
   * @param index of the cluster
   * @return at least 0; at 0 there is no measurement
   */
  double newEvents(int index);

  /**
   * How many of the new events lay within another cluster as well, and so may be the other's.
   *
   * @param index of the cluster
   * @return 0 to {@link #newEvents}
   */
  double contestedEvents(int index);

  /**
   * Column of the measured centre: mean over the new events, each without the mean offset of its
   * polarity from the centre.
   *
   * @param index of the cluster
   * @return pixels; NaN without new events
   */
  double measuredX(int index);

  /**
   * Row of the measured centre: mean over the new events, each without the mean offset of its
   * polarity from the centre.
   *
   * @param index of the cluster
   * @return pixels; NaN without new events
   */
  double measuredY(int index);

  /**
   * How long before the reading the new events were, on average: the measurement is of that time.
   *
   * @param index of the cluster
   * @return microseconds, above 0; NaN without new events
   */
  double measuredAgeUs(int index);

  /**
   * Variance of a single event's column about the centre; that of the measurement is this over the
   * number of new events, at best: neighbouring pixels that fire together are not independent.
   *
   * @param index of the cluster
   * @return pixels squared, above 0
   */
  double eventVarianceX(int index);

  /**
   * Variance of a single event's row about the centre.
   *
   * @param index of the cluster
   * @return pixels squared, above 0
   */
  double eventVarianceY(int index);

  /**
   * Covariance of a single event's column and row about the centre.
   *
   * @param index of the cluster
   * @return pixels squared
   */
  double eventCovarianceXy(int index);

  /**
   * Variance, along an axis, of where the middle of the thing is about the measured centre however
   * many events there are: of what the border cuts off only a part is seen.
   *
   * @param index of the cluster
   * @return pixels squared; 0 in the open
   */
  double unseenVariance(int index);

  /**
   * Where the events lie on a straight line that goes on beyond the cluster, its direction: nothing
   * is known of the place along it, and the measured one is what the cluster had, moved across.
   *
   * @param index of the cluster
   * @return component to the right of a vector of length 1, or 0 with {@link #lineY} where there is
   *     no such line
   */
  double lineX(int index);

  /**
   * Direction of a line, see {@link #lineX}.
   *
   * @param index of the cluster
   * @return component upwards
   */
  double lineY(int index);

  /**
   * Information on the column of the centre that the new events hold if they lie on a round
   * outline, of which no more than a part need be seen: an entry of the inverse of a covariance.
   *
   * @param index of the cluster
   * @return 1 over pixels squared; 0 if there is no such outline
   */
  double outlineXx(int index);

  /**
   * Information on column and row together, see {@link #outlineXx}.
   *
   * @param index of the cluster
   * @return 1 over pixels squared
   */
  double outlineXy(int index);

  /**
   * Information on the row, see {@link #outlineXx}.
   *
   * @param index of the cluster
   * @return 1 over pixels squared
   */
  double outlineYy(int index);

  /**
   * First component of the information times the centre of the outline, at the time of {@link
   * #measuredAgeUs}. Unlike the centre itself it exists also where only one direction is known.
   *
   * @param index of the cluster
   * @return 1 over pixels
   */
  double outlineX(int index);

  /**
   * Second component, see {@link #outlineX}.
   *
   * @param index of the cluster
   * @return 1 over pixels
   */
  double outlineY(int index);

  /**
   * Variance, along an axis, of where the middle of the thing is about that of the outline however
   * many events there are: those of two things taken for one lie on no ring as closely as those of
   * one do.
   *
   * @param index of the cluster
   * @return pixels squared; 0 where they lie on a ring as closely as pixels let them
   */
  double outlineMisfitVariance(int index);

  /**
   * Radius within which events belong to the cluster; of an ellipse the geometric mean of its half
   * axes.
   *
   * @param index of the cluster
   * @return pixels, above 0
   */
  double radiusPx(int index);

  /**
   * Events that the cluster has taken since its birth.
   *
   * @param index of the cluster
   * @return at least 1
   */
  long events(int index);

  /**
   * Recent events, each counting less the longer ago it was.
   *
   * @param index of the cluster
   * @return at least 0
   */
  double mass(int index);

  /**
   * Time since the cluster's birth; it was born before it was visible.
   *
   * @param index of the cluster
   * @return microseconds
   */
  long ageUs(int index);

  /**
   * Whether another cluster overlaps this one now, so that some of its events may be the other's.
   *
   * @param index of the cluster
   * @return true near a crossing
   */
  boolean overlapped(int index);

  /**
   * Feeds an estimate back: the cluster goes on from there. Not a number or a place outside the
   * sensor by more than the cluster's radius is ignored.
   *
   * @param index of the cluster
   * @param xPx column of the centre at the time of the reading, pixels
   * @param yPx row of the centre at the time of the reading, pixels
   * @param vxPxPerS velocity to the right, pixels a second
   * @param vyPxPerS velocity upwards, pixels a second
   */
  void feedBack(int index, double xPx, double yPx, double vxPxPerS, double vyPxPerS);

  /**
   * Keeps a cluster that gets no events alive, say because it is hidden and will come out again.
   *
   * @param index of the cluster
   * @param untilUs until when it does not die for want of events, microseconds
   */
  void keepAlive(int index, long untilUs);

  /**
   * Keeps two clusters from merging, since they are known to be two things. The edges in front and
   * behind of a thing, of which one has ON events only and the other OFF events, merge all the
   * same.
   *
   * @param index of a cluster
   * @param other index of the other
   * @param untilUs how long they are kept apart, microseconds
   */
  void keepApart(int index, int other, long untilUs);
}
