package haltere.filters.estimation;

/**
 * What an estimator does when nothing came for so long that its prediction is worth nothing.
 *
 * @param action what is done about a longer time step
 * @param longestS seconds; time steps up to this are predicted as they are
 */
public record GapPolicy(Action action, double longestS) {
  /** What is done about a time step longer than the longest. */
  public enum Action {
    /** Predict the longest step only: the state coasts that far, the covariance grows no more. */
    CAP,
    /** Begin again from the state and covariance of the last launch. */
    RELAUNCH
  }

  /** Predicts at most ten seconds ahead. */
  public static final GapPolicy DEFAULT = cap(10);

  /** Predicts any step as it is; for simulations whose steps are known. */
  public static final GapPolicy UNLIMITED = new GapPolicy(Action.CAP, Double.POSITIVE_INFINITY);

  /** Validates. */
  public GapPolicy {
    if (!(longestS > 0)) {
      throw new IllegalArgumentException("longest step must be positive: " + longestS + " s");
    }
  }

  /**
   * Predicts at most so far; the state stands still for the rest of a gap.
   *
   * @param longestS seconds, positive
   * @return the policy
   */
  public static GapPolicy cap(double longestS) {
    return new GapPolicy(Action.CAP, longestS);
  }

  /**
   * Begins again after a longer gap.
   *
   * @param longestS seconds, positive
   * @return the policy
   */
  public static GapPolicy relaunch(double longestS) {
    return new GapPolicy(Action.RELAUNCH, longestS);
  }

  boolean relaunches(double dtS) {
    return action == Action.RELAUNCH && dtS > longestS;
  }

  double predicted(double dtS) {
    return Math.min(dtS, longestS);
  }
}
