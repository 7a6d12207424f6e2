package haltere.filters.estimation;

/**
 * What an estimator does when nothing came for so long that its prediction is worth nothing. A gap
 * is the time since the last measurement that was taken in, or since the launch, whether it is
 * predicted in one step or in many.
 *
 * @param action what is done about a longer gap
 * @param longestS seconds; gaps up to this are predicted as they are
 */
public record GapPolicy(Action action, double longestS) {
  /** What is done about a gap longer than the longest. */
  public enum Action {
    /** Predict the longest gap only: the state coasts that far, the covariance grows no more. */
    CAP,
    /** Begin again from the state and covariance of the last launch. */
    RELAUNCH
  }

  /** Predicts at most ten seconds ahead. */
  public static final GapPolicy DEFAULT = cap(10);

  /** Predicts any gap as it is; for simulations whose steps are known. */
  public static final GapPolicy UNLIMITED = new GapPolicy(Action.CAP, Double.POSITIVE_INFINITY);

  /** Validates. */
  public GapPolicy {
    if (!(longestS > 0)) {
      throw new IllegalArgumentException("longest gap must be positive: " + longestS + " s");
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

  boolean relaunches(double gapS, double dtS) {
    return action == Action.RELAUNCH && gapS + dtS > longestS;
  }

  /** How much of a time step is predicted, with a gap before it. */
  double predicted(double gapS, double dtS) {
    return Math.max(0, Math.min(dtS, longestS - gapS));
  }
}
