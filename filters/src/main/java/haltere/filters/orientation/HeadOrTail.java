package haltere.filters.orientation;

import org.apache.commons.statistics.distribution.ChiSquaredDistribution;

/**
 * Resolves head and tail by the displacement of the body along the axis: the sum of steps with
 * exponential memory. Its noise is that of two positions, since errors between them cancel; a
 * velocity would be noisier. The decision changes only if the displacement is clearly backwards, so
 * that a body which slips in a turn keeps its head.
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

  /** Clears the displacement after a re-initialisation of the axis; the decision stays. */
  void clearDisplacement() {
    wayM = 0;
    sigmas = 0;
  }

  /** Keeps the head when the axis is reversed. */
  void reverse() {
    wayM = -wayM;
    sigmas = -sigmas;
    flipped = !flipped;
  }

  /** Adds a displacement along the axis in metres, with the variance of the position along it. */
  void step(double alongM, double varianceM2, double dtS) {
    if (!Double.isFinite(alongM) || !(varianceM2 > 0)) {
      return;
    }
    double sd = Math.sqrt(2 * varianceM2);
    double max = settings.limitSigmas() * sd;
    wayM = wayM * Math.exp(-dtS / settings.memoryS()) + alongM;
    wayM = Math.max(-max, Math.min(max, wayM));
    sigmas = wayM / sd;
    double forwards = sign() * sigmas;
    if (!decided) {
      flipped = wayM < 0;
      decided = Math.abs(sigmas) > settings.exchangeSigmas();
    } else if (forwards < -settings.exchangeSigmas()) {
      flipped = !flipped;
    }
  }

  /** 1 if the axis points to the head, −1 if to the tail. */
  double sign() {
    return flipped ? -1 : 1;
  }

  /** Probability that the displacement was towards the head. */
  double probability() {
    double forwards = sign() * sigmas;
    double within = ChiSquaredDistribution.of(1).cumulativeProbability(forwards * forwards);
    return 0.5 * (1 + Math.signum(forwards) * within);
  }
}
