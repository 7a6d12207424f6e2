package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.assertClose;
import static haltere.filters.estimation.Matrices.column;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.internal.example.Oscillations;
import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.estimation.motion.DampedOscillator;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ModelsTest {
  /** Linear models are the same at every state. */
  private static final DMatrixRMaj ANY = column(0);

  static List<ProcessModel> linearModels() {
    return List.of(
        AxisMotion.constantVelocity(1, 2),
        AxisMotion.constantVelocity(3, 0.5),
        AxisMotion.constantAcceleration(1, 3),
        AxisMotion.constantAcceleration(2, 3),
        AxisMotion.whiteJerk(1, 4),
        AxisMotion.whiteJerk(2, 4));
  }

  @ParameterizedTest
  @MethodSource("linearModels")
  void twoStepsEqualOneLongStep(ProcessModel model) {
    int n = model.stateSize();
    DMatrixRMaj f1 = new DMatrixRMaj(n, n);
    DMatrixRMaj f2 = new DMatrixRMaj(n, n);
    DMatrixRMaj f = new DMatrixRMaj(n, n);
    DMatrixRMaj q1 = new DMatrixRMaj(n, n);
    DMatrixRMaj q2 = new DMatrixRMaj(n, n);
    DMatrixRMaj q = new DMatrixRMaj(n, n);
    model.jacobian(ANY, 0.3, f1);
    model.jacobian(ANY, 0.9, f2);
    model.jacobian(ANY, 1.2, f);
    model.noise(ANY, 0.3, q1);
    model.noise(ANY, 0.9, q2);
    model.noise(ANY, 1.2, q);
    DMatrixRMaj product = new DMatrixRMaj(n, n);
    CommonOps_DDRM.mult(f2, f1, product);
    assertClose(f, product, 1e-15);
    assertClose(q, Matrices.propagated(f2, q1, q2), 1e-14);
  }

  @Test
  void noiseMatchesThePublishedMatrices() {
    double t = 0.7;
    double q = 3;
    DMatrixRMaj jerk = new DMatrixRMaj(3, 3);
    AxisMotion.whiteJerk(1, q).noise(ANY, t, jerk);
    DMatrixRMaj published =
        Matrices.rows(
            new double[] {Math.pow(t, 5) / 20, Math.pow(t, 4) / 8, Math.pow(t, 3) / 6},
            new double[] {Math.pow(t, 4) / 8, Math.pow(t, 3) / 3, t * t / 2},
            new double[] {Math.pow(t, 3) / 6, t * t / 2, t});
    CommonOps_DDRM.scale(q, published);
    assertClose(published, jerk, 1e-15);
    DMatrixRMaj velocity = new DMatrixRMaj(2, 2);
    AxisMotion.constantVelocity(1, q).noise(ANY, t, velocity);
    DMatrixRMaj acceleration =
        Matrices.rows(
            new double[] {q * t * t * t / 3, q * t * t / 2}, new double[] {q * t * t / 2, q * t});
    assertClose(acceleration, velocity, 1e-15);
  }

  @Test
  void axesAreIndependent() {
    DMatrixRMaj f = new DMatrixRMaj(4, 4);
    AxisMotion.constantVelocity(2, 1).jacobian(ANY, 0.25, f);
    DMatrixRMaj expected = CommonOps_DDRM.identity(4);
    expected.set(0, 1, 0.25);
    expected.set(2, 3, 0.25);
    assertClose(expected, f, 0);
  }

  @Test
  void noisePerStepIsConstant() {
    AxisMotion model = AxisMotion.constantVelocity(2, 7).withNoisePerStep(0.3);
    DMatrixRMaj expected = Matrices.diagonal(0.3, 0.3, 0.3, 0.3);
    DMatrixRMaj q = new DMatrixRMaj(4, 4);
    for (double dtS : new double[] {1e-6, 1, 100}) {
      model.noise(ANY, dtS, q);
      assertClose(expected, q, 0);
    }
    DMatrixRMaj f = new DMatrixRMaj(4, 4);
    DMatrixRMaj plain = new DMatrixRMaj(4, 4);
    model.jacobian(ANY, 0.5, f);
    AxisMotion.constantVelocity(2, 0).jacobian(ANY, 0.5, plain);
    assertClose(plain, f, 0);
  }

  @Test
  void oscillatorFollowsTheExactSolution() {
    double zeta = 0.1;
    double omega = 4.3;
    DampedOscillator model = new DampedOscillator(Double.POSITIVE_INFINITY);
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
  void jacobiansMatchDifferenceQuotients() {
    Draws draws = new Draws(6);
    for (int i = 0; i < 200; i++) {
      DMatrixRMaj x =
          column(
              draws.normal(10), draws.normal(50), draws.uniform(-0.3, 1.5), draws.uniform(0.1, 20));
      assertJacobian(new DampedOscillator(Double.POSITIVE_INFINITY), x, draws.uniform(0.001, 0.5));
      assertJacobian(AxisMotion.whiteJerk(1, 1), column(1, 2, 3), draws.uniform(0.001, 2));
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
  void fastOscillatorOverALongGapTakesBoundedTime() {
    DMatrixRMaj after = new DMatrixRMaj(4, 1);
    new DampedOscillator(Double.POSITIVE_INFINITY).evolve(column(1, 0, 0.1, 1e9), 3600, after);
    assertTrue(Double.isFinite(after.get(2)));
    new DampedOscillator(100).evolve(column(1, 0, 0.1, 1e9), 3600, after);
    assertTrue(Double.isNaN(after.get(0)), "too fast for the measurements");
  }
}
