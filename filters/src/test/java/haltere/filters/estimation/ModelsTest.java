package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.assertClose;
import static haltere.filters.estimation.Matrices.column;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.example.Oscillations;
import haltere.filters.estimation.motion.ConstantAcceleration;
import haltere.filters.estimation.motion.ConstantNoise;
import haltere.filters.estimation.motion.ConstantVelocity;
import haltere.filters.estimation.motion.DampedOscillator;
import haltere.filters.estimation.motion.WhiteJerk;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ModelsTest {
  static List<LinearProcessModel> linearModels() {
    return List.of(
        new ConstantVelocity(1, 2),
        new ConstantVelocity(3, 0.5),
        new ConstantAcceleration(1, 3),
        new ConstantAcceleration(2, 3),
        new WhiteJerk(1, 4),
        new WhiteJerk(2, 4));
  }

  @ParameterizedTest
  @MethodSource("linearModels")
  void twoStepsAreOneLongStep(LinearProcessModel model) {
    int n = model.stateSize();
    DMatrixRMaj f1 = new DMatrixRMaj(n, n);
    DMatrixRMaj f2 = new DMatrixRMaj(n, n);
    DMatrixRMaj f = new DMatrixRMaj(n, n);
    DMatrixRMaj q1 = new DMatrixRMaj(n, n);
    DMatrixRMaj q2 = new DMatrixRMaj(n, n);
    DMatrixRMaj q = new DMatrixRMaj(n, n);
    model.transition(0.3, f1);
    model.transition(0.9, f2);
    model.transition(1.2, f);
    model.noise(0.3, q1);
    model.noise(0.9, q2);
    model.noise(1.2, q);
    DMatrixRMaj product = new DMatrixRMaj(n, n);
    CommonOps_DDRM.mult(f2, f1, product);
    assertClose(f, product, 1e-15);
    assertClose(q, Matrices.propagated(f2, q1, q2), 1e-14);
  }

  @Test
  void theirNoiseIsThatOfThePublishedMatrices() {
    double t = 0.7;
    double q = 3;
    DMatrixRMaj jerk = new DMatrixRMaj(3, 3);
    new WhiteJerk(1, q).noise(t, jerk);
    DMatrixRMaj published =
        Matrices.rows(
            new double[] {Math.pow(t, 5) / 20, Math.pow(t, 4) / 8, Math.pow(t, 3) / 6},
            new double[] {Math.pow(t, 4) / 8, Math.pow(t, 3) / 3, t * t / 2},
            new double[] {Math.pow(t, 3) / 6, t * t / 2, t});
    CommonOps_DDRM.scale(q, published);
    assertClose(published, jerk, 1e-15);
    DMatrixRMaj velocity = new DMatrixRMaj(2, 2);
    new ConstantVelocity(1, q).noise(t, velocity);
    DMatrixRMaj acceleration =
        Matrices.rows(
            new double[] {q * t * t * t / 3, q * t * t / 2}, new double[] {q * t * t / 2, q * t});
    assertClose(acceleration, velocity, 1e-15);
  }

  @Test
  void axesDoNotTouchEachOther() {
    DMatrixRMaj f = new DMatrixRMaj(4, 4);
    new ConstantVelocity(2, 1).transition(0.25, f);
    DMatrixRMaj expected = CommonOps_DDRM.identity(4);
    expected.set(0, 1, 0.25);
    expected.set(2, 3, 0.25);
    assertClose(expected, f, 0);
  }

  @Test
  void constantNoiseIsTheSameAtEveryStep() {
    LinearProcessModel model = ConstantNoise.perStep(new ConstantVelocity(2, 7), 0.3);
    DMatrixRMaj expected = Matrices.diagonal(0.3, 0.3, 0.3, 0.3);
    DMatrixRMaj q = new DMatrixRMaj(4, 4);
    for (double dtS : new double[] {1e-6, 1, 100}) {
      model.noise(dtS, q);
      assertClose(expected, q, 0);
    }
    DMatrixRMaj f = new DMatrixRMaj(4, 4);
    DMatrixRMaj plain = new DMatrixRMaj(4, 4);
    model.transition(0.5, f);
    new ConstantVelocity(2, 0).transition(0.5, plain);
    assertClose(plain, f, 0);
  }

  @Test
  void theOscillatorFollowsTheExactSolution() {
    double zeta = 0.1;
    double omega = 4.3;
    DampedOscillator model = new DampedOscillator(0, 0, 0);
    DMatrixRMaj x = column(2, -5, zeta, omega);
    DMatrixRMaj after = new DMatrixRMaj(4, 1);
    for (double dtS : new double[] {0.004, 0.1, 1, 10}) {
      model.evolve(x, dtS, after);
      double[] exact = Oscillations.exact(2, -5, zeta, omega, dtS);
      assertEquals(exact[0], after.get(0), 2e-4, "after " + dtS + " s");
      assertEquals(exact[1], after.get(1), 1e-3, "after " + dtS + " s");
      assertEquals(zeta, after.get(2));
      assertEquals(omega, after.get(3));
    }
  }

  @Test
  void jacobiansAreTheDifferenceQuotientsOfTheirModels() {
    Draws draws = new Draws(6);
    for (int i = 0; i < 200; i++) {
      DMatrixRMaj x =
          column(
              draws.normal(10), draws.normal(50), draws.uniform(-0.3, 1.5), draws.uniform(0.1, 20));
      assertJacobian(new DampedOscillator(1, 1, 1), x, draws.uniform(0.001, 0.5));
      assertJacobian(new WhiteJerk(1, 1), column(1, 2, 3), draws.uniform(0.001, 2));
      assertMeasurementJacobian(new WingEdge.Angle(1, Gate.OPEN), x);
    }
  }

  private static void assertJacobian(ProcessModel model, DMatrixRMaj x, double dtS) {
    int n = model.stateSize();
    DMatrixRMaj f = new DMatrixRMaj(n, n);
    model.jacobian(x, dtS, f);
    DMatrixRMaj quotients = new DMatrixRMaj(n, n);
    for (int j = 0; j < n; j++) {
      double h = 1e-5 * Math.max(1, Math.abs(x.get(j)));
      DMatrixRMaj above = new DMatrixRMaj(n, 1);
      DMatrixRMaj below = new DMatrixRMaj(n, 1);
      DMatrixRMaj moved = x.copy();
      moved.set(j, x.get(j) + h);
      model.evolve(moved, dtS, above);
      moved.set(j, x.get(j) - h);
      model.evolve(moved, dtS, below);
      for (int i = 0; i < n; i++) {
        quotients.set(i, j, (above.get(i) - below.get(i)) / (2 * h));
      }
    }
    assertClose(quotients, f, 2e-6);
  }

  private static void assertMeasurementJacobian(MeasurementModel model, DMatrixRMaj x) {
    DMatrixRMaj h = new DMatrixRMaj(1, x.numRows);
    model.jacobian(x, h);
    DMatrixRMaj above = new DMatrixRMaj(1, 1);
    DMatrixRMaj below = new DMatrixRMaj(1, 1);
    for (int j = 0; j < x.numRows; j++) {
      DMatrixRMaj moved = x.copy();
      moved.set(j, x.get(j) + 1e-5);
      model.expected(moved, above);
      moved.set(j, x.get(j) - 1e-5);
      model.expected(moved, below);
      assertEquals((above.get(0) - below.get(0)) / 2e-5, h.get(0, j), 1e-6);
    }
  }

  @Test
  void theOscillatorsNoiseIsTheIntegralOverTheStep() {
    DampedOscillator model = new DampedOscillator(3, 0.02, 0.5);
    DMatrixRMaj x = column(4, -20, 0.1, 5);
    for (double dtS : new double[] {0.01, 0.1, 0.6}) {
      DMatrixRMaj q = new DMatrixRMaj(4, 4);
      model.noise(x, dtS, q);
      Matrices.assertSameCovariance(bySmallSteps(model, x, dtS), q, 0.02);
      DMatrixRMaj u = new DMatrixRMaj(4, 4);
      double[] d = new double[4];
      UdFactors.of(q, u, d);
      for (double pivot : d) {
        assertTrue(pivot > 0, "positive definite");
      }
    }
  }

  /** ∫ Φ G Gᵀ Φᵀ as a sum over a thousand steps: Q ← F Q Fᵀ + diag(density) h. */
  private static DMatrixRMaj bySmallSteps(DampedOscillator model, DMatrixRMaj x, double dtS) {
    DMatrixRMaj state = x.copy();
    DMatrixRMaj next = new DMatrixRMaj(4, 1);
    DMatrixRMaj f = new DMatrixRMaj(4, 4);
    DMatrixRMaj q = new DMatrixRMaj(4, 4);
    double h = dtS / 1000;
    DMatrixRMaj white = Matrices.diagonal(0, 3 * h, 0.02 * h, 0.5 * h);
    for (int i = 0; i < 1000; i++) {
      model.jacobian(state, h, f);
      q = Matrices.propagated(f, q, white);
      model.evolve(state, h, next);
      state.setTo(next);
    }
    return q;
  }

  @Test
  void aVeryFastOscillatorOverALongGapTakesBoundedTime() {
    DMatrixRMaj after = new DMatrixRMaj(4, 1);
    new DampedOscillator(0, 0, 0).evolve(column(1, 0, 0.1, 1e9), 3600, after);
    assertThrows(IllegalArgumentException.class, () -> new DampedOscillator(-1, 0, 0));
  }
}
