package haltere.filters.track.motion;

import java.util.Arrays;

/**
 * Mean and covariance of several modes together, each with its weight. Thread rule: that of its
 * owner.
 */
final class ModeMixture {
  private final MotionNoise noise;
  private final int modes;

  /** Which share of the targets that leave a mode, a row each, goes on in each other one. */
  private final double[] shares;

  /** The share of each mode; they add up to 1. */
  private final double[] weights;

  /** The probability that each mode has been left. */
  private final double[] leave;

  ModeMixture(MotionNoise noise) {
    this.noise = noise;
    modes = noise.modes();
    weights = new double[modes];
    leave = new double[modes];
    shares = new double[modes * modes];
    for (int i = 0; i < modes; i++) {
      for (int j = 0; j < modes; j++) {
        shares[modes * i + j] = i == j ? 0 : noise.share(i, j);
      }
    }
  }

  /** Lets modes be left for a time. */
  void goOn(double dtS) {
    int last = modes - 1;
    // All but the last are left at the same rate.
    double usual = noise.leave(0, dtS);
    for (int i = 0; i < last; i++) {
      leave[i] = usual;
    }
    leave[last] = noise.leave(last, dtS);
  }

  /**
   * Weighs modes by how probable it is that a target was in each, if it is in a certain one now.
   *
   * @param probability of each before {@link #goOn}
   * @return the probability that it is in that one
   */
  double weighTransitions(double[] probability, int to) {
    double sum = 0;
    for (int i = 0; i < modes; i++) {
      double stays = i == to ? 1 - leave[i] : leave[i] * shares[modes * i + to];
      weights[i] = probability[i] * stays;
      sum += weights[i];
    }
    double perSum = 1 / sum;
    for (int i = 0; i < modes; i++) {
      weights[i] *= perSum;
    }
    return sum;
  }

  /**
   * Mixes modes by their weights. A rate is mixed only where one is wanted.
   *
   * @param of stay as they are
   * @param mean of the mixture, is written
   * @param spread its covariance, is written, in the order of {@link PlaneFilter#p}
   * @param unknownRate the variance of an unknown rate, or 0 for none
   */
  void mix(PlaneFilter[] of, double[] mean, double[] spread, double unknownRate) {
    boolean rates = unknownRate > 0;
    Arrays.fill(mean, 0);
    Arrays.fill(spread, 0);
    for (int i = 0; i < modes; i++) {
      double w = weights[i];
      double[] x = of[i].x;
      mean[0] += w * x[0];
      mean[1] += w * x[1];
      mean[2] += w * x[2];
      mean[3] += w * x[3];
      mean[4] += rates ? w * x[4] : 0;
    }
    for (int i = 0; i < modes; i++) {
      addSpread(of[i], mean, weights[i], spread, rates);
      if (rates && noise.rateVariance(i) == 0) {
        spread[PlaneFilter.ENTRIES - 1] += weights[i] * unknownRate;
      }
    }
  }

  /** Adds the weight times P + (x - mean) (x - mean)ᵀ; in the order of the entries of P. */
  private static void addSpread(
      PlaneFilter of, double[] mean, double weight, double[] spread, boolean rates) {
    double[] x = of.x;
    double[] p = of.p;
    double d0 = x[0] - mean[0];
    double d1 = x[1] - mean[1];
    double d2 = x[2] - mean[2];
    double d3 = x[3] - mean[3];
    spread[0] += weight * (p[0] + d0 * d0);
    spread[1] += weight * (p[1] + d0 * d1);
    spread[2] += weight * (p[2] + d0 * d2);
    spread[3] += weight * (p[3] + d0 * d3);
    spread[4] += weight * (p[4] + d1 * d1);
    spread[5] += weight * (p[5] + d1 * d2);
    spread[6] += weight * (p[6] + d1 * d3);
    spread[7] += weight * (p[7] + d2 * d2);
    spread[8] += weight * (p[8] + d2 * d3);
    spread[9] += weight * (p[9] + d3 * d3);
    if (rates) {
      double d4 = x[4] - mean[4];
      spread[10] += weight * (p[10] + d0 * d4);
      spread[11] += weight * (p[11] + d1 * d4);
      spread[12] += weight * (p[12] + d2 * d4);
      spread[13] += weight * (p[13] + d3 * d4);
      spread[14] += weight * (p[14] + d4 * d4);
    }
  }
}
