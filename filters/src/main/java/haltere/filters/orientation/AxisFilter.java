package haltere.filters.orientation;

/**
 * Follows the undirected axis of a body through what cameras see of it.
 *
 * <p>Thread rule: one thread at a time. Nothing is allocated by a step.
 */
sealed interface AxisFilter permits SphereFilter, QuaternionFilter {
  /**
   * Begins.
   *
   * @param axis unit vector
   * @param covariance of it in the world's coordinates, nine entries of rank 2
   */
  void launch(double[] axis, double[] covariance);

  /**
   * Goes on in time. A step of 0 is none.
   *
   * @param dtS seconds, finite, not negative
   */
  void predict(double dtS);

  /**
   * Takes in what several cameras saw at one time; says in each whether it was used.
   *
   * @param lines the first {@code count} of them
   * @param count at least 0
   */
  void update(LineMeasurement[] lines, int count);

  /** Puts the axis into an array of three. */
  void axis(double[] out);

  /** Puts the velocity of the axis' tip, per second, into an array of three. */
  void tipVelocity(double[] out);

  /** Mean squared angle between the estimate and the truth, not capped. */
  double axisVariance();

  /** Standard deviation of the rotation about the axis, which no camera sees. */
  double rollSd();

  /** The rate of roll that the filter holds, 0 where it is left out. */
  double rollRate();

  /** Whether all numbers are finite. */
  boolean isSound();
}
