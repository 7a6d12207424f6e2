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

  /**
   * Initialises with an axis.
   *
   * @param found the axis with its covariance and odds
   */
  void launch(AxisLaunch found);

  /**
   * Predicts.
   *
   * @param dtS time step, seconds, finite, not negative
   */
  void predict(double dtS);

  /**
   * Updates with lines of one time and sets their results.
   *
   * @param lines the first ones are used
   * @param count their number
   */
  void update(LineMeasurement[] lines, int count);

  /**
   * Updates with the direction of flight: the direction of the head plus a random angle.
   *
   * @param direction a unit vector
   * @param variance of the angle in each direction, squared radians
   * @param fresh new share of the angle since the last time, above 0, at most 1
   */
  default void coupleToFlight(double[] direction, double variance, double fresh) {}

  /**
   * Whether to search the axis again, after an update.
   *
   * @param lines of the update
   * @param count their number
   * @return true if the axis may be wrong
   */
  boolean needsSearch(LineMeasurement[] lines, int count);

  /**
   * Adds an alternative axis.
   *
   * @param found the axis with its covariance and odds
   * @return whether it replaces the present one
   */
  boolean offer(AxisLaunch found);

  /** {@return the estimate} */
  Axis axis();

  /** {@return whether all numbers are finite} */
  boolean isValid();

  /** Records each step for a smoother; this allocates. */
  default void record() {}

  /** {@return the last step, with its predecessors; null without a smoother} */
  default AxisStep step() {
    return null;
  }
}
