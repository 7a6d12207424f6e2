package haltere.filters.orientation;

import haltere.filters.estimation.GaussianState;
import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Several hypotheses of an axis together: their mean, in the tangent plane of the likeliest, and
 * their second moment about it. Each one points the way that it has been followed, so hypotheses
 * more than 90 degrees apart have a mean between them, not one beside the line of both. Reused.
 */
final class AxisMixture {
  private final AxisHypothesis mean = new AxisHypothesis();
  private final AxisDifference difference = new AxisDifference();
  private final GaussianState[] pool = new GaussianState[HypothesisSet.MAX_SPLIT];

  /** Nothing to sum up yet. */
  AxisMixture() {
    Arrays.setAll(pool, i -> new GaussianState(4));
  }

  /**
   * Sums up.
   *
   * @param hypotheses the likeliest first, with probabilities that add up to 1
   * @param unknown probability that none of them is right
   * @param unknownVariance variance of the axis then, in each direction
   */
  void of(HypothesisSet hypotheses, double unknown, double unknownVariance) {
    AxisHypothesis best = hypotheses.get(0);
    mean.copy(best);
    int count = hypotheses.size();
    if (count > 1) {
      GaussianState[] parts = Arrays.copyOf(pool, count);
      double[] weights = new double[count];
      for (int i = 0; i < count; i++) {
        weights[i] = hypotheses.get(i).weight;
        difference.betweenHeads(best, hypotheses.get(i));
        difference.carry(parts[i]);
      }
      mean.error.mix(parts, weights);
      mean.recentre(false);
    }
    if (unknown > 0) {
      DMatrixRMaj p = mean.error.covariance();
      CommonOps_DDRM.scale(1 - unknown, p);
      for (int i = 0; i < 4; i++) {
        p.add(i, i, unknown * (i % 2 == 0 ? unknownVariance : best.error.covariance(i, i)));
      }
    }
  }

  /** The mean with its covariance. */
  AxisHypothesis mean() {
    return mean;
  }

  double axisVariance() {
    return mean.error.covariance(0, 0) + mean.error.covariance(2, 2);
  }

  /** Probability of the hypotheses that are nearer to the mean than to its opposite. */
  double agreement(HypothesisSet hypotheses) {
    double sum = 0;
    for (int i = 0; i < hypotheses.size(); i++) {
      AxisHypothesis each = hypotheses.get(i);
      sum += Vectors.dot(each.u, mean.u) > 0 ? each.weight : 0;
    }
    return Math.min(1, sum);
  }
}
