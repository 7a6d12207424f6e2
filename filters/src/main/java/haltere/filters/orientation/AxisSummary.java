package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;

/**
 * What several guesses of an axis say together: their mean, in the tangent plane of the likeliest,
 * and their second moment about it. Each guess points the way that it has been followed, so guesses
 * more than 90 degrees apart have a mean between them, not one beside the line of both. Reused.
 */
final class AxisSummary {
  private final AxisHypothesis mean = new AxisHypothesis();
  private final AxisDifference difference = new AxisDifference();
  private final double[] offset = new double[4];
  private final double[] p = new double[16];

  /**
   * Sums up.
   *
   * @param guesses the likeliest first, with probabilities that add up to 1
   * @param unknown probability that none of them is right
   * @param unknownVariance variance of the axis then, in each direction
   */
  void of(HypothesisSet guesses, double unknown, double unknownVariance) {
    AxisHypothesis best = guesses.get(0);
    mean.copy(best);
    best.covariance(p);
    Arrays.fill(offset, 0);
    if (guesses.size() > 1) {
      double own = best.weight;
      for (int k = 0; k < 16; k++) {
        p[k] *= own;
      }
      for (int g = 1; g < guesses.size(); g++) {
        add(best, guesses.get(g));
      }
      for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
          p[4 * i + j] -= offset[i] * offset[j];
        }
      }
      mean.move(offset);
    }
    if (unknown > 0) {
      for (int k = 0; k < 16; k++) {
        p[k] *= 1 - unknown;
      }
      p[0] += unknown * unknownVariance;
      p[10] += unknown * unknownVariance;
      p[5] += unknown * best.error.covariance(1, 1);
      p[15] += unknown * best.error.covariance(3, 3);
    }
  }

  private void add(AxisHypothesis best, AxisHypothesis other) {
    double w = other.weight;
    difference.betweenHeads(best, other);
    difference.carryCovariance(other);
    double[] d = difference.d;
    for (int i = 0; i < 4; i++) {
      offset[i] += w * d[i];
      for (int j = 0; j < 4; j++) {
        p[4 * i + j] += w * (difference.p[4 * i + j] + d[i] * d[j]);
      }
    }
  }

  void axis(double[] out) {
    System.arraycopy(mean.u, 0, out, 0, 3);
  }

  void tipVelocity(double[] out) {
    for (int i = 0; i < 3; i++) {
      out[i] = mean.va * mean.e1[i] + mean.vb * mean.e2[i];
    }
  }

  double axisVariance() {
    return p[0] + p[10];
  }

  /** Probability of the guesses that are nearer to the mean than to its opposite. */
  double agreement(HypothesisSet guesses) {
    double sum = 0;
    for (int g = 0; g < guesses.size(); g++) {
      AxisHypothesis guess = guesses.get(g);
      sum += Vectors.dot(guess.u, mean.u) > 0 ? guess.weight : 0;
    }
    return Math.min(1, sum);
  }

  AxisState state() {
    return new AxisState(
        mean.u.clone(), mean.e1.clone(), mean.e2.clone(), mean.va, mean.vb, p.clone());
  }
}
