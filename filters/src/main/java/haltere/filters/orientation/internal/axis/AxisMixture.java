package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.GaussianState;
import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The mixture of hypotheses of an axis: mean, in the tangent plane of the likeliest, and second
 * moment about it. Hypotheses are directed: the mean of two more than 90 degrees apart is between
 * their heads. Reused.
 */
final class AxisMixture {
  private final HypothesisSet hypotheses;
  private final double unknownVariance;
  private final AxisHypothesis mean = new AxisHypothesis();
  private final AxisDifference difference = new AxisDifference();
  private final GaussianState[] parts = new GaussianState[HypothesisSet.MAX_LASTING];
  private final GaussianState mixed = new GaussianState(4);
  private double unknown;
  private boolean isPresent;

  /**
   * A mixture of hypotheses, the likeliest first, with probabilities that add up to 1, and of the
   * variance of the axis in each direction if none of them is true.
   */
  AxisMixture(HypothesisSet hypotheses, double unknownVariance) {
    this.hypotheses = hypotheses;
    this.unknownVariance = unknownVariance;
    Arrays.setAll(parts, i -> new GaussianState(4));
  }

  /** Sets the probability that no hypothesis is true, after a change of the hypotheses. */
  void changed(double newUnknown) {
    unknown = newUnknown;
    isPresent = false;
  }

  /** The mean with the covariance of the mixture. */
  AxisHypothesis mean() {
    if (isPresent) {
      return mean;
    }
    AxisHypothesis best = hypotheses.get(0);
    int count = hypotheses.size();
    double[] weights = new double[count];
    parts[0].set(best.error);
    for (int i = 0; i < count; i++) {
      weights[i] = hypotheses.get(i).weight;
      if (i > 0) {
        difference.between(best, hypotheses.get(i), 1);
        difference.carry(parts[i]);
      }
    }
    mixed.mix(Arrays.copyOf(parts, count), weights);
    CommonOps_DDRM.subtractEquals(mixed.mean(), best.error.mean());
    mean.copy(best);
    mean.move(mixed.mean().data);
    DMatrixRMaj p = mean.error.covariance();
    CommonOps_DDRM.scale(1 - unknown, mixed.covariance(), p);
    for (int i = 0; i < 4; i++) {
      p.add(i, i, unknown * (i % 2 == 0 ? unknownVariance : best.error.covariance(i, i)));
    }
    isPresent = true;
    return mean;
  }

  double axisVariance() {
    return mean().angleVariance();
  }

  /** Probability of the hypotheses that are nearer to the mean than to its opposite. */
  double agreement() {
    double sum = 0;
    for (int i = 0; i < hypotheses.size(); i++) {
      AxisHypothesis each = hypotheses.get(i);
      sum += Vectors.dot(each.u, mean().u) > 0 ? each.weight : 0;
    }
    return Math.min(1, sum);
  }
}
