package haltere.filters.orientation.internal.axis;

/**
 * Filter of the undirected axis of a body from the lines of cameras.
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
   * @param rollSd standard deviation of roll, which is not observable
   * @param rollRate roll rate, 0 if it is no state
   */
  record Axis(
      double[] u,
      double[] tipVelocity,
      double variance,
      double agreement,
      boolean isSettled,
      double rollSd,
      double rollRate) {}

  /** Initialises with an axis. */
  void launch(AxisLaunch found);

  /** Predicts by seconds, finite, not negative. */
  void predict(double dtS);

  /** Updates with a number of lines of one time and sets their results. */
  void update(LineMeasurement[] lines, int count);

  /**
   * Updates with the direction of flight, a unit vector: the direction of the head plus an angle
   * with a variance in each direction. Fresh is the new share of this angle since the last time,
   * above 0, at most 1.
   */
  default void coupleToFlight(double[] direction, double variance, double fresh) {}

  /** Whether to search the axis again, after an update. */
  boolean doubts(LineMeasurement[] lines, int count);

  /** Adds an alternative axis; returns whether it replaces the present one. */
  boolean offer(AxisLaunch found);

  /** The estimate. */
  Axis axis();

  /** Whether all numbers are finite. */
  boolean isSound();

  /** Records each step for a smoother; this allocates. */
  default void record() {}

  /** The last step, with its predecessors; null without a smoother. */
  default AxisStep step() {
    return null;
  }
}
