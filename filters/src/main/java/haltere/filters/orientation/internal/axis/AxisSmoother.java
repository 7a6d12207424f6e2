package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.RtsSmoother;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.ejml.data.DMatrixRMaj;

/**
 * Smooths the steps of {@link SphereFilter} by {@link RtsSmoother}, with sums and differences along
 * great circles. P⁻ includes the noise of calm flight and of saccades by their probabilities.
 */
public final class AxisSmoother {
  private AxisSmoother() {}

  /**
   * Smooths a path.
   *
   * @param steps of one hypothesis, in order
   * @return a state for each step
   */
  public static List<AxisState> smooth(List<AxisStep> steps) {
    List<AxisState> smoothed = new ArrayList<>(steps.size());
    AxisState later = null;
    for (int k = steps.size() - 1; k >= 0; k--) {
      AxisStep next = k + 1 < steps.size() ? steps.get(k + 1) : null;
      boolean isLinked = next != null && next.predicted() != null;
      AxisState at = steps.get(k).updated();
      later = isLinked ? smoothStep(at, next, later) : at;
      smoothed.add(later);
    }
    Collections.reverse(smoothed);
    return smoothed;
  }

  private static AxisState smoothStep(AxisState at, AxisStep next, AxisState later) {
    AxisHypothesis expected = hypothesis(next.predicted());
    AxisHypothesis found = hypothesis(later);
    AxisHypothesis moved = hypothesis(at);
    AxisDifference difference = new AxisDifference();
    difference.between(expected, found, 1);
    DMatrixRMaj change = DMatrixRMaj.wrap(4, 1, difference.d);
    boolean isDone =
        RtsSmoother.smoothStep(
            moved.error.covariance(),
            next.transition(),
            expected.error.covariance(),
            found.error.covariance(),
            change);
    moved.move(change.data);
    return isDone && moved.isValid() ? moved.state() : at;
  }

  private static AxisHypothesis hypothesis(AxisState state) {
    AxisHypothesis hypothesis = new AxisHypothesis();
    hypothesis.set(state);
    return hypothesis;
  }
}
