package haltere.filters.orientation;

import haltere.filters.estimation.GaussianState;
import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The mixture of hypotheses of an axis: mean, in the tangent plane of the likeliest, and second
 * moment about it. Hypotheses have a head: the mean of two that are more than 90 degrees apart lies
 * between their heads. Reused.
 */
final class AxisMixture {
  private final HypothesisSet hypotheses;
  private final double unknownVariance;
  private final AxisHypothesis mean = new AxisHypothesis();
  private final AxisDifference[] differences = new AxisDifference[HypothesisSet.MAX_KEPT];
  private final GaussianState[] pool = new GaussianState[HypothesisSet.MAX_KEPT];
  private final GaussianState mixed = new GaussianState(4);
  private double unknown;
  private boolean hasMean;
  private boolean hasCovariance;

  /**
   * A mixture of hypotheses, the likeliest first, with probabilities that add up to 1, and of the
   * variance of the axis in each direction if none of them is true.
   */
  AxisMixture(HypothesisSet hypotheses, double unknownVariance) {
    this.hypotheses = hypotheses;
    this.unknownVariance = unknownVariance;
    Arrays.setAll(differences, i -> new AxisDifference());
    Arrays.setAll(pool, i -> new GaussianState(4));
  }

  /** Sets the probability that no hypothesis is true, after a change of the hypotheses. */
  void changed(double newUnknown) {
    unknown = newUnknown;
    hasMean = false;
    hasCovariance = false;
  }

  /** The mean; its covariance is that of the likeliest hypothesis. */
  AxisHypothesis mean() {
    if (!hasMean) {
      double[] offset = new double[4];
      mean.copy(hypotheses.get(0));
      for (int i = 1; i < hypotheses.size(); i++) {
        differences[i].between(hypotheses.get(0), hypotheses.get(i), 1);
        for (int k = 0; k < 4; k++) {
          offset[k] += hypotheses.get(i).weight * differences[i].d[k];
        }
      }
      mean.move(offset);
      hasMean = true;
    }
    return mean;
  }

  /** The mean with the covariance of the mixture. */
  AxisHypothesis meanWithCovariance() {
    if (!hasCovariance) {
      AxisHypothesis best = hypotheses.get(0);
      DMatrixRMaj p = mean().error.covariance();
      int count = hypotheses.size();
      if (count > 1) {
        double[] weights = new double[count];
        pool[0].set(best.error);
        weights[0] = best.weight;
        for (int i = 1; i < count; i++) {
          weights[i] = hypotheses.get(i).weight;
          differences[i].carry(pool[i]);
        }
        mixed.mix(Arrays.copyOf(pool, count), weights);
        p.setTo(mixed.covariance());
      }
      CommonOps_DDRM.scale(1 - unknown, p);
      for (int i = 0; i < 4; i++) {
        p.add(i, i, unknown * (i % 2 == 0 ? unknownVariance : best.error.covariance(i, i)));
      }
      hasCovariance = true;
    }
    return mean;
  }

  double axisVariance() {
    return meanWithCovariance().angleVariance();
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
