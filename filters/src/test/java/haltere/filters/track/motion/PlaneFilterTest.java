package haltere.filters.track.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.LinearMeasurement;
import haltere.filters.estimation.motion.ConstantVelocity;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlaneFilterTest {
  /** Order of the states here, in the order (x, vx, y, vy) of the general filter. */
  private static final int[] GENERAL = {0, 2, 1, 3};

  @Test
  void inAStraightLineItIsTheGeneralFilterOfConstantVelocity() {
    double density = 300;
    PlaneFilter fast = new PlaneFilter();
    fast.launch(10, 20, 2, 0.5, 3, 1e4, 0);
    DMatrixRMaj p =
        new DMatrixRMaj(
            new double[][] {{2, 0, 0.5, 0}, {0, 1e4, 0, 0}, {0.5, 0, 3, 0}, {0, 0, 0, 1e4}});
    KalmanFilter clear =
        new KalmanFilter(
            new ConstantVelocity(2, density),
            new DMatrixRMaj(new double[][] {{10}, {0}, {20}, {0}}),
            p);
    SplittableRandom random = new SplittableRandom(1);
    for (int k = 0; k < 500; k++) {
      double dt = random.nextDouble(0, 0.03);
      fast.evolve(dt);
      fast.addNoise(dt, density, 0);
      clear.predict(dt);
      double zx = fast.x[0] + random.nextDouble(-2, 2);
      double zy = fast.x[1] + random.nextDouble(-2, 2);
      assertTrue(fast.innovate(zx, zy, 1.5, 0, 0.8));
      fast.correct();
      clear.update(LinearMeasurement.ofEntries(4, 1.5, 0), new DMatrixRMaj(new double[][] {{zx}}));
      clear.update(LinearMeasurement.ofEntries(4, 0.8, 2), new DMatrixRMaj(new double[][] {{zy}}));
      for (int i = 0; i < 4; i++) {
        assertEquals(clear.state(GENERAL[i]), fast.x[i], 1e-7 * (1 + Math.abs(fast.x[i])));
        for (int j = 0; j < 4; j++) {
          double expected = clear.covariance(GENERAL[i], GENERAL[j]);
          assertEquals(
              expected, fast.covariance(i, j), 1e-7 * (1 + Math.abs(expected)), i + " " + j);
        }
      }
    }
  }

  @Test
  void aTurningTargetGoesOnACircle() {
    PlaneFilter filter = new PlaneFilter();
    filter.launch(30, 0, 1, 0, 1, 1, 1);
    filter.x[3] = 60;
    filter.x[4] = 2;
    for (int k = 0; k < 100; k++) {
      filter.evolve(Math.PI / 2 / 100);
    }
    assertArrayEquals(new double[] {-30, 0, 0, -60, 2}, filter.x, 1e-9);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-9, 1e-3, 0.7, -5})
  void theCovarianceEvolvesByTheJacobianOfTheEvolution(double turnRate) {
    double dt = 0.05;
    double[] start = {3, -4, 50, -20, turnRate};
    DMatrixRMaj jacobian = new DMatrixRMaj(5, 5);
    for (int j = 0; j < 5; j++) {
      double step = 1e-5;
      double[] above = evolved(start, j, step, dt);
      double[] below = evolved(start, j, -step, dt);
      for (int i = 0; i < 5; i++) {
        jacobian.set(i, j, (above[i] - below[i]) / (2 * step));
      }
    }
    PlaneFilter filter = new PlaneFilter();
    filter.launch(0, 0, 2, 0.3, 1, 9, 4);
    DMatrixRMaj before = covariance(filter);
    System.arraycopy(start, 0, filter.x, 0, 5);
    filter.evolve(dt);
    DMatrixRMaj half = new DMatrixRMaj(5, 5);
    DMatrixRMaj expected = new DMatrixRMaj(5, 5);
    CommonOps_DDRM.mult(jacobian, before, half);
    CommonOps_DDRM.multTransB(half, jacobian, expected);
    assertArrayEquals(expected.data, covariance(filter).data, 1e-5);
  }

  private static DMatrixRMaj covariance(PlaneFilter filter) {
    DMatrixRMaj p = new DMatrixRMaj(5, 5);
    for (int i = 0; i < 5; i++) {
      for (int j = 0; j < 5; j++) {
        p.set(i, j, filter.covariance(i, j));
      }
    }
    return p;
  }

  /** Joseph's form on whole matrices is the reference. */
  @Test
  void aTurningTargetIsCorrectedByJosephsForm() {
    SplittableRandom random = new SplittableRandom(3);
    for (int run = 0; run < 50; run++) {
      PlaneFilter filter = new PlaneFilter();
      filter.launch(0, 0, 2, 0.3, 1, 900, 4);
      filter.x[3] = 100;
      filter.x[4] = random.nextDouble(-3, 3);
      for (int k = 0; k < 20; k++) {
        filter.evolve(0.02);
        filter.addNoise(0.02, 100, 1);
        DMatrixRMaj before = covariance(filter);
        double rxx = random.nextDouble(0.1, 2);
        double ryy = random.nextDouble(0.1, 2);
        assertTrue(filter.innovate(filter.x[0] + 0.5, filter.x[1] - 0.2, rxx, 0.05, ryy));
        filter.correct();
        assertArrayEquals(
            joseph(before, filter, rxx, ryy).data, covariance(filter).data, 1e-9 * 900);
      }
    }
  }

  private static DMatrixRMaj joseph(DMatrixRMaj p, PlaneFilter filter, double rxx, double ryy) {
    DMatrixRMaj gain = new DMatrixRMaj(5, 2);
    DMatrixRMaj left = CommonOps_DDRM.identity(5);
    for (int i = 0; i < 5; i++) {
      for (int j = 0; j < 2; j++) {
        gain.set(i, j, filter.gain(i, j));
        left.add(i, j, -gain.get(i, j));
      }
    }
    DMatrixRMaj r = new DMatrixRMaj(new double[][] {{rxx, 0.05}, {0.05, ryy}});
    return CommonOps_DDRM.add(turned(left, p), turned(gain, r), null);
  }

  /** A B Aᵀ. */
  private static DMatrixRMaj turned(DMatrixRMaj a, DMatrixRMaj b) {
    DMatrixRMaj half = CommonOps_DDRM.mult(a, b, null);
    return CommonOps_DDRM.multTransB(half, a, null);
  }

  private static double[] evolved(double[] start, int index, double step, double dt) {
    PlaneFilter filter = new PlaneFilter();
    filter.launch(0, 0, 1, 0, 1, 1, 1);
    System.arraycopy(start, 0, filter.x, 0, 5);
    filter.x[index] += step;
    filter.evolve(dt);
    return filter.x.clone();
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e8})
  void afterTenMillionUpdatesTheCovarianceIsStillOne(double ratio) {
    PlaneFilter filter = new PlaneFilter();
    filter.launch(0, 0, 1e4, 0, 1e4, 1e6, 64);
    for (int k = 0; k < 10_000_000; k++) {
      filter.evolve(1e-3);
      filter.addNoise(1e-3, ratio, ratio * 1e-3);
      filter.innovate(0, 0, 1, 0.3, 2);
      filter.correct();
    }
    DMatrixRMaj p = covariance(filter);
    assertTrue(DecompositionFactory_DDRM.chol(5, true).decompose(p), "P is not positive: " + p);
  }

  @Test
  void whatIsNotANumberCannotBeCompared() {
    PlaneFilter filter = new PlaneFilter();
    filter.launch(0, 0, 1, 0, 1, 1, 0);
    assertFalse(filter.innovate(Double.NaN, 0, 1, 0, 1));
    assertFalse(filter.innovate(0, Double.POSITIVE_INFINITY, 1, 0, 1));
    assertFalse(filter.innovate(0, 0, Double.NaN, 0, 1));
    assertFalse(filter.innovate(0, 0, -5, 0, 1));
  }
}
