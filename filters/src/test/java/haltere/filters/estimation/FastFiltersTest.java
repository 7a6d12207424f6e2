package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.ConstantVelocity;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/** The written-out filters do what the clear ones do. */
class FastFiltersTest {
  private static final double RELATIVE = 1e-9;

  @Test
  void theFilterOfAPlaneIsTheClearOneOfFourStates() {
    for (int seed = 0; seed < 100; seed++) {
      Draws draws = new Draws(seed);
      double q = Math.exp(draws.uniform(-5, 12));
      double r = Math.exp(draws.uniform(-5, 5));
      Gate gate = Gate.sigmas(3);
      ConstantVelocityPlane fast = new ConstantVelocityPlane(q, gate, 20);
      fast.launch(3, -4, 9, 1e5);
      KalmanFilter clear =
          new KalmanFilter(
              new ConstantVelocity(2, q),
              Matrices.column(3, 0, -4, 0),
              Matrices.diagonal(9, 1e5, 9, 1e5));
      LinearMeasurement place = LinearMeasurement.ofEntries(4, r, 0, 2).withGate(gate);
      for (int k = 0; k < 200; k++) {
        double dtS = draws.uniform(0, 0.01);
        fast.predict(dtS);
        clear.predict(dtS);
        double x = 3 + draws.normal(10);
        double y = -4 + draws.normal(10);
        assertEquals(clear.update(place, x, y), fast.update(x, y, r), "outcome of " + k);
        assertEquals(clear.nis(), fast.nis(), 1e-7 * clear.nis());
      }
      assertEquals(clear.monitor().longestRun(), fast.monitor().longestRun());
      DMatrixRMaj p = Matrices.covarianceOf(clear);
      assertAxis(clear, p, 0, fast.x());
      assertAxis(clear, p, 2, fast.y());
    }
  }

  private static void assertAxis(
      KalmanFilter clear, DMatrixRMaj p, int at, ConstantVelocityAxis axis) {
    double sdPosition = Math.sqrt(p.get(at, at));
    double sdVelocity = Math.sqrt(p.get(at + 1, at + 1));
    assertEquals(clear.state(at), axis.position(), RELATIVE * (sdPosition + 10));
    assertEquals(clear.state(at + 1), axis.velocity(), RELATIVE * (sdVelocity + 1000));
    assertEquals(p.get(at, at), axis.positionVariance(), RELATIVE * p.get(at, at));
    assertEquals(p.get(at, at + 1), axis.crossCovariance(), RELATIVE * sdPosition * sdVelocity);
    assertEquals(p.get(at + 1, at + 1), axis.velocityVariance(), RELATIVE * p.get(at + 1, at + 1));
  }

  @Test
  void theFilterOfFourStatesIsTheClearOneOnAWing() {
    for (int seed = 0; seed < 100; seed++) {
      Draws draws = new Draws(seed);
      double[] q = {0.02, 0.5, 2, 8000};
      double r = Math.exp(draws.uniform(-8, -2));
      Gate gate = Gate.sigmas(4);
      DMatrixRMaj x = Matrices.column(1.5, 1, draws.uniform(-3, 3), 1200);
      DMatrixRMaj p = Matrices.diagonal(0.1, 0.1, 1, 100 * 100);
      ExtendedKalmanFilter clear = new ExtendedKalmanFilter(new WingEdge(q), x, p);
      WingEdge.Angle angle = new WingEdge.Angle(r, gate);
      FourStateEkf fast = new FourStateEkf(gate, 20);
      fast.setState(x.get(0), x.get(1), x.get(2), x.get(3));
      fast.setVariances(0.1, 0.1, 1, 1e4);
      double truth = x.get(2) + draws.normal(0.5);
      for (int k = 0; k < 300; k++) {
        double dtS = k % 7 == 0 ? 0 : draws.uniform(0, 1e-4);
        truth += 1250 * dtS;
        double z = 1.5 + Math.sin(truth) + draws.normal(Math.sqrt(r));
        clear.predict(dtS);
        fast.predict(0, 0, 0, 0, 0, dtS);
        fast.addNoise(q[0] * dtS, q[1] * dtS, q[2] * dtS, q[3] * dtS);
        double sin = Math.sin(fast.x2());
        double cos = Math.cos(fast.x2());
        double y = Angles.wrapPi(z - (fast.x0() + fast.x1() * sin));
        UpdateOutcome outcome = fast.update(y, 1, sin, fast.x1() * cos, 0, r);
        assertEquals(clear.update(angle, z), outcome, "outcome of " + k);
        assertEquals(clear.nis(), fast.nis(), 1e-6 * clear.nis() + 1e-12);
      }
      assertSame(clear, fast, 1e-7);
    }
  }

  @Test
  void itsTransitionsMayBeTriangularOrAny() {
    Draws draws = new Draws(77);
    for (int run = 0; run < 200; run++) {
      double[] f = new double[16];
      for (int i = 0; i < 16; i++) {
        f[i] = draws.normal(1);
      }
      double[] triangle = f.clone();
      for (int i = 0; i < 4; i++) {
        triangle[5 * i] = 1;
        for (int j = 0; j < i; j++) {
          triangle[4 * i + j] = 0;
        }
      }
      FourStateEkf fast = correlated(draws.uniform(0.1, 2));
      FourStateEkf fastTriangle = correlated(fast.covariance(0, 0));
      DMatrixRMaj p = covarianceOf(fast);
      DMatrixRMaj pTriangle = covarianceOf(fastTriangle);
      fast.predictCovariance(f);
      fastTriangle.predict(
          triangle[1], triangle[2], triangle[3], triangle[6], triangle[7], triangle[11]);
      DMatrixRMaj none = new DMatrixRMaj(4, 4);
      Matrices.assertSameCovariance(
          Matrices.propagated(new DMatrixRMaj(4, 4, true, f), p, none), covarianceOf(fast), 1e-12);
      DMatrixRMaj ft = new DMatrixRMaj(4, 4, true, triangle);
      Matrices.assertSameCovariance(
          Matrices.propagated(ft, pTriangle, none), covarianceOf(fastTriangle), 1e-12);
      double[] x = {1, 2, -3, 4};
      assertEquals(
          x[0] + triangle[1] * 2 - triangle[2] * 3 + triangle[3] * 4, fastTriangle.x0(), 1e-12);
      assertEquals(x[1] - triangle[6] * 3 + triangle[7] * 4, fastTriangle.x1(), 1e-12);
      assertEquals(x[2] + triangle[11] * 4, fastTriangle.x2(), 1e-12);
      assertEquals(x[3], fastTriangle.x3());
    }
  }

  private static FourStateEkf correlated(double scale) {
    FourStateEkf filter = new FourStateEkf(Gate.OPEN, 20);
    filter.setState(1, 2, -3, 4);
    filter.setVariances(scale, 2, 3, 1);
    filter.addPairNoise(0.1, 0.2);
    filter.update(0, 1, -0.5, 0.3, 0.7, 1e9);
    return filter;
  }

  @Test
  void constantVelocityInAPlaneFitsTheFourStatesToo() {
    double q = 5;
    FourStateEkf fast = new FourStateEkf(Gate.OPEN, 20);
    fast.setState(0, 1, 2, 3);
    fast.setVariances(1, 2, 3, 4);
    KalmanFilter clear =
        new KalmanFilter(
            new ConstantVelocity(2, q), Matrices.column(0, 1, 2, 3), Matrices.diagonal(1, 2, 3, 4));
    LinearMeasurement place = LinearMeasurement.ofEntries(4, 0.5, 0, 2);
    Draws draws = new Draws(1);
    for (int k = 0; k < 100; k++) {
      double dt = draws.uniform(0.01, 0.1);
      double zx = draws.normal(3);
      double zy = draws.normal(3);
      clear.predict(dt);
      clear.update(place, zx, zy);
      fast.predict(dt, 0, 0, 0, 0, dt);
      double noise = q * dt;
      fast.addNoise(noise * dt * dt / 3, noise, noise * dt * dt / 3, noise);
      fast.addPairNoise(noise * dt / 2, noise * dt / 2);
      fast.update(zx - fast.x0(), 1, 0, 0, 0, 0.5);
      fast.update(zy - fast.x2(), 0, 0, 1, 0, 0.5);
    }
    assertSame(clear, fast, 1e-11);
  }

  @Test
  void numbersThatAreNoneChangeNothing() {
    ConstantVelocityPlane plane = new ConstantVelocityPlane(1, Gate.OPEN, 20);
    plane.launch(1, 2, 3, 4);
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
      assertEquals(UpdateOutcome.UNUSABLE, plane.update(bad, 0, 1));
      assertEquals(UpdateOutcome.UNUSABLE, plane.update(0, bad, 1));
      assertEquals(UpdateOutcome.UNUSABLE, plane.update(0, 0, bad));
      assertFalse(plane.x().update(bad, 1));
      assertFalse(plane.x().update(1, bad));
    }
    assertEquals(UpdateOutcome.UNUSABLE, plane.update(0, 0, -1));
    assertEquals(UpdateOutcome.UNUSABLE, plane.update(0, 0, 1, 0));
    assertEquals(1, plane.x().position());
    assertEquals(3, plane.y().positionVariance());
    FourStateEkf four = new FourStateEkf(Gate.OPEN, 20);
    four.setState(1, 2, 3, 4);
    four.setVariances(1, 1, 1, 1);
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
      assertEquals(UpdateOutcome.UNUSABLE, four.update(bad, 1, 0, 0, 0, 1));
      assertEquals(UpdateOutcome.UNUSABLE, four.update(0, bad, 0, 0, 0, 1));
      assertEquals(UpdateOutcome.UNUSABLE, four.update(0, 1, 0, 0, 0, bad));
    }
    assertEquals(UpdateOutcome.UNUSABLE, four.update(0, 1, 0, 0, 0, 0));
    assertEquals(1, four.x0());
    assertEquals(1, four.covariance(0, 0));
    assertEquals(7, four.monitor().unusable());
    assertThrows(IllegalArgumentException.class, () -> four.setState(0, Double.NaN, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> four.setVariances(1, 1, 0, 1));
    assertThrows(IllegalArgumentException.class, () -> plane.predict(-1));
    assertThrows(IllegalArgumentException.class, () -> plane.predict(1, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> plane.launch(0, 0, 0, 1));
    assertThrows(IllegalArgumentException.class, () -> new ConstantVelocityAxis(-1));
    assertTrue(four.monitor().applied() == 0);
  }

  private static void assertSame(Estimator<?> clear, FourStateEkf fast, double relative) {
    DMatrixRMaj p = Matrices.covarianceOf(clear);
    Matrices.assertSameCovariance(p, covarianceOf(fast), relative);
    double[] x = {fast.x0(), fast.x1(), fast.x2(), fast.x3()};
    for (int i = 0; i < 4; i++) {
      assertEquals(clear.state(i), x[i], relative * (Math.abs(x[i]) + Math.sqrt(p.get(i, i))));
    }
  }

  private static DMatrixRMaj covarianceOf(FourStateEkf fast) {
    DMatrixRMaj p = new DMatrixRMaj(4, 4);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        p.set(i, j, fast.covariance(i, j));
      }
    }
    return p;
  }
}
