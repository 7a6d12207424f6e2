package haltere.filters.orientation;

/**
 * Follows the undirected axis of a body through what cameras see of it.
 *
 * <p>Thread rule: one thread at a time.
 */
sealed interface AxisFilter permits SphereFilter, QuaternionFilter {
  /** Begins with an axis that was found. */
  void launch(AxisLaunch found);

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

  /**
   * Takes in that a body flies more or less where its head points (flight-direction coupling).
   *
   * @param direction unit vector, of the flight
   * @param variance of the angle between axis and flight in each direction, squared radians
   * @param fresh share of that angle that is another than an instant ago, greater than 0, at most 1
   */
  void coupleToFlight(double[] direction, double variance, double fresh);

  /**
   * Whether the axis had better be looked for anew, after these lines were taken in.
   *
   * @param lines the first {@code count} of them
   * @param count at least 0
   */
  boolean doubts(LineMeasurement[] lines, int count);

  /**
   * Takes note of an axis that was found anew while there is one; returns whether it now is the
   * axis.
   */
  boolean offer(AxisLaunch found);

  /** Probability that the axis is nearer to the estimate than to its opposite. */
  double agreement();

  /** Whether the axis is not in doubt, so that it tells where the head is. */
  boolean isSettled();

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

  /** From now on keeps each instant for a smoother; this allocates. */
  void record();

  /** The last instant, with the way to it; null if the form has no smoother. */
  AxisStep step();

  /** The state; without a covariance if it is of quaternions. */
  AxisState state();
}
