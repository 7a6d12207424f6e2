package haltere.filters.orientation.internal.axis;

/**
 * Follows the undirected axis of a body through what cameras see of it.
 *
 * <p>Thread rule: one thread at a time.
 */
public sealed interface AxisFilter permits SphereFilter, QuaternionFilter {
  /**
   * Estimate of an axis.
   *
   * @param u unit vector
   * @param tipVelocity velocity of its tip, per second
   * @param variance mean squared angle to the true axis, not capped
   * @param agreement probability that the true axis is nearer to u than to its opposite
   * @param isSettled whether it is unambiguous, so that its head is known by continuity
   * @param rollSd standard deviation of the rotation about the axis, which no camera sees
   * @param rollRate the rate of roll that the filter holds, 0 where it is left out
   */
  record Axis(
      double[] u,
      double[] tipVelocity,
      double variance,
      double agreement,
      boolean isSettled,
      double rollSd,
      double rollRate) {}

  /** Starts with an axis that was found. */
  void launch(AxisLaunch found);

  /** Predicts by seconds, finite, not negative. */
  void predict(double dtS);

  /** Updates with the first lines, of one time, and sets their results. */
  void update(LineMeasurement[] lines, int count);

  /**
   * Updates with the direction of flight, a unit vector, which is that of the head but for an angle
   * of a variance in each direction (flight-direction coupling). Fresh is the share of that angle
   * that is new since the last time, above 0, at most 1.
   */
  default void coupleToFlight(double[] direction, double variance, double fresh) {}

  /** Whether to search the axis again, after an update with the first lines. */
  boolean doubts(LineMeasurement[] lines, int count);

  /** Adds an axis that was found beside the present one; returns whether it replaces it. */
  boolean offer(AxisLaunch found);

  /** The estimate. */
  Axis axis();

  /** Whether all numbers are finite. */
  boolean isSound();

  /** From now on keeps each step for a smoother; this allocates. */
  default void record() {}

  /** The last step, with those before; null if the form has no smoother. */
  default AxisStep step() {
    return null;
  }
}
