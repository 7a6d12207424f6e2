package haltere.filters.orientation.internal.axis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.orientation.camera.Vectors;
import org.junit.jupiter.api.Test;

class HypothesisSetTest {
  @Test
  void meanOfDistantHypothesesLiesBetweenTheirHeads() {
    HypothesisSet hypotheses = new HypothesisSet();
    double[] small = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4};
    double[] left = {Math.cos(1), Math.sin(1), 0};
    double[] right = {Math.cos(1), -Math.sin(1), 0};
    hypotheses.add().launch(left, small, 1);
    hypotheses.add().launch(right, small, 1);
    hypotheses.settle(0);
    AxisMixture mixture = new AxisMixture(hypotheses, 1);
    assertEquals(0, Vectors.angle(mixture.mean().u, new double[] {1, 0, 0}), 1e-9);
    assertEquals(1, Math.sqrt(mixture.axisVariance()), 1e-3);
    assertEquals(1, mixture.agreement(), 1e-12);
  }

  @Test
  void backwardHypothesesAreReversedOnTheSameLine() {
    AxisHypothesis hypothesis = new AxisHypothesis();
    double[] covariance = {0.04, 0.01, 0, 0.01, 0.02, 0, 0, 0, 0.01};
    hypothesis.launch(new double[] {0.1, -0.2, 1}, covariance, 2);
    hypothesis.move(new double[] {0, 0.5, 0, -0.7});
    AxisState before = hypothesis.state();
    hypothesis.face(before.u(), 1);
    assertEquals(0, Vectors.angle(before.u(), hypothesis.u), 1e-12, "a head that is ahead stays");
    hypothesis.face(new double[] {-before.u()[0], -before.u()[1], -before.u()[2]}, 1);
    AxisState turned = hypothesis.state();
    assertEquals(Math.PI, Vectors.angle(before.u(), turned.u()), 1e-7);
    double[] expected = before.p();
    for (int k = 0; k < 3; k++) {
      double velocity = before.va() * before.e1()[k] + before.vb() * before.e2()[k];
      double tail = turned.va() * turned.e1()[k] + turned.vb() * turned.e2()[k];
      assertEquals(-velocity, tail, 1e-12);
    }
    assertEquals(expected[0], turned.p()[0], 1e-12);
    assertEquals(-expected[2], turned.p()[2], 1e-12);
    assertEquals(expected[10], turned.p()[10], 1e-12);
  }
}
