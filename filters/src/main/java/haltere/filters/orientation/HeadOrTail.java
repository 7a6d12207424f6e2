package haltere.filters.orientation;

import org.apache.commons.statistics.distribution.ChiSquaredDistribution;

/**
 * Which end of the axis is the head, while the body flies: two hypotheses, the axis as it is
 * followed and its opposite, resolved by the way that the body has flown along it.
 *
 * <p>That way is the sum of steps along the axis, older ones counting less. Its noise is that of
 * the two ends only, since the error of a position counts once forwards and once backwards; so a
 * tenth of a body length decides where a velocity would not. The decision is changed only when the
 * opposite is clear, so that a body which slips sideways in a turn keeps its head.
 */
final class HeadOrTail {
  private final OrientationSettings.HeadTail settings;
  private double wayM;
  private double sigmas;
  private boolean decided;
  private boolean flipped;

  HeadOrTail(OrientationSettings.HeadTail settings) {
    this.settings = settings;
  }

  /** The axis was lost and found: what was flown before tells no more, the decision stays. */
  void doubt() {
    wayM = 0;
    sigmas = 0;
  }

  /** The axis is followed by its other end. */
  void turnRound() {
    wayM = -wayM;
    sigmas = -sigmas;
    flipped = !flipped;
  }

  /**
   * A step.
   *
   * @param alongM how far the body has come along the axis, metres
   * @param varianceM2 variance of its position along the axis, square metres
   * @param dtS in which time
   */
  void step(double alongM, double varianceM2, double dtS) {
    if (!Double.isFinite(alongM) || !(varianceM2 > 0)) {
      return;
    }
    double sd = Math.sqrt(2 * varianceM2);
    double most = settings.certaintySigmas() * sd;
    wayM = wayM * Math.exp(-dtS / settings.memoryS()) + alongM;
    wayM = Math.max(-most, Math.min(most, wayM));
    sigmas = wayM / sd;
    double forwards = sign() * sigmas;
    if (!decided) {
      flipped = wayM < 0;
      decided = Math.abs(sigmas) > settings.doubtSigmas();
    } else if (forwards < -settings.doubtSigmas()) {
      flipped = !flipped;
    }
  }

  /** 1 if the head is where the axis that is followed points, −1 if it is opposite. */
  double sign() {
    return flipped ? -1 : 1;
  }

  /** Probability that the head is where it is taken to be: that the way flown was forwards. */
  double probability() {
    double forwards = sign() * sigmas;
    double within = ChiSquaredDistribution.of(1).cumulativeProbability(forwards * forwards);
    return 0.5 * (1 + Math.signum(forwards) * within);
  }
}
