package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.AxisMotion;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;

class RtsSmootherTest {
  private static final int STANDS = 25;

  @Test
  void smoothedPathIsTheMostProbablePath() {
    Draws draws = new Draws(31);
    double variance = 0.09;
    DMatrixRMaj x0 = column(1, 2);
    DMatrixRMaj p0 = diagonal(4, 1);
    AxisMotion model = AxisMotion.constantVelocity(1, 0.7);
    KalmanFilter filter = new KalmanFilter(model, x0, p0);
    List<FilterStep> steps = new ArrayList<>();
    filter.observe(steps::add);
    LinearMeasurement position = LinearMeasurement.ofEntries(2, variance, 0);
    // The path that minimises the sum of all squared errors: one large system.
    DMatrixRMaj information = new DMatrixRMaj(2 * STANDS, 2 * STANDS);
    DMatrixRMaj right = new DMatrixRMaj(2 * STANDS, 1);
    for (int i = 0; i < 2; i++) {
      information.add(i, i, 1 / p0.get(i, i));
      right.add(i, 0, x0.get(i) / p0.get(i, i));
    }
    for (int k = 0; k < STANDS; k++) {
      if (k > 0) {
        double dtS = draws.uniform(0.05, 0.3);
        filter.predict(dtS);
        addTransition(information, model, dtS, 2 * (k - 1));
      }
      if (k % 5 != 3) {
        double z = 1 + k * 0.3 + draws.normal(0.3);
        filter.update(position, z);
        information.add(2 * k, 2 * k, 1 / variance);
        right.add(2 * k, 0, z / variance);
      }
    }
    DMatrixRMaj path = new DMatrixRMaj(2 * STANDS, 1);
    DMatrixRMaj covariance = new DMatrixRMaj(2 * STANDS, 2 * STANDS);
    assertTrue(CommonOps_DDRM.solve(information, right, path));
    assertTrue(CommonOps_DDRM.invert(information, covariance));
    List<Estimate> smoothed = RtsSmoother.smooth(steps);
    assertEquals(STANDS, smoothed.size());
    for (int k = 0; k < STANDS; k++) {
      for (int i = 0; i < 2; i++) {
        assertEquals(path.get(2 * k + i), smoothed.get(k).value(i), 1e-9);
        for (int j = 0; j < 2; j++) {
          assertEquals(
              covariance.get(2 * k + i, 2 * k + j), smoothed.get(k).covariance().get(i, j), 1e-9);
        }
      }
    }
    assertEquals(filter.estimate(), smoothed.get(STANDS - 1));
  }

  private static void addTransition(DMatrixRMaj information, AxisMotion model, double dtS, int at) {
    DMatrixRMaj f = new DMatrixRMaj(2, 2);
    DMatrixRMaj q = new DMatrixRMaj(2, 2);
    model.jacobian(column(0, 0), dtS, f);
    model.noise(column(0, 0), dtS, q);
    assertTrue(CommonOps_DDRM.invert(q));
    // Error x₊ − F x = [−F I] (x, x₊), weighted with Q⁻¹.
    DMatrixRMaj a = new DMatrixRMaj(2, 4);
    CommonOps_DDRM.changeSign(f);
    CommonOps_DDRM.insert(f, a, 0, 0);
    CommonOps_DDRM.insert(CommonOps_DDRM.identity(2), a, 0, 2);
    DMatrixRMaj qa = new DMatrixRMaj(2, 4);
    DMatrixRMaj block = new DMatrixRMaj(4, 4);
    CommonOps_DDRM.mult(q, a, qa);
    CommonOps_DDRM.multTransA(a, qa, block);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        information.add(at + i, at + j, block.get(i, j));
      }
    }
  }

  @Test
  void smoothedErrorsAreConsistent() {
    int runs = 200;
    double nees = 0;
    double filteredSquare = 0;
    double smoothedSquare = 0;
    AxisMotion model = AxisMotion.constantVelocity(1, 2);
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 0.5, 0);
    for (int run = 0; run < runs; run++) {
      Draws draws = new Draws(500 + run);
      DMatrixRMaj truth = draws.normal(diagonal(4, 4));
      KalmanFilter filter = new KalmanFilter(model, column(0, 0), diagonal(4, 4));
      List<FilterStep> steps = new ArrayList<>();
      filter.observe(steps::add);
      DMatrixRMaj q = new DMatrixRMaj(2, 2);
      double[] middle = new double[2];
      double filtered = 0;
      for (int k = 1; k <= 40; k++) {
        DMatrixRMaj next = new DMatrixRMaj(2, 1);
        model.evolve(truth, 0.1, next);
        model.noise(truth, 0.1, q);
        CommonOps_DDRM.add(next, draws.normal(q), truth);
        filter.predict(0.1);
        filter.update(position, truth.get(0) + draws.normal(Math.sqrt(0.5)));
        if (k == 20) {
          middle = truth.data.clone();
          filtered = filter.state(0);
        }
      }
      Estimate smoothed = RtsSmoother.smooth(steps).get(20);
      nees += Consistency.nees(smoothed, middle) / runs;
      filteredSquare += Math.pow(filtered - middle[0], 2);
      smoothedSquare += Math.pow(smoothed.value(0) - middle[0], 2);
    }
    Interval band = Consistency.meanBand(2, runs, 0.95);
    assertTrue(band.contains(nees), "NEES " + nees + " in " + band);
    assertTrue(smoothedSquare < 0.7 * filteredSquare, "looking back helps");
  }

  @Test
  void reInitialisationSplitsThePath() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1), column(0, 0), diagonal(1, 1));
    List<FilterStep> steps = new ArrayList<>();
    filter.observe(steps::add);
    filter.predict(1);
    Estimate before = filter.estimate();
    filter.launch(column(50, 0), diagonal(1, 1));
    filter.predict(1);
    filter.update(LinearMeasurement.ofEntries(2, 0.1, 0), 55);
    List<Estimate> smoothed = RtsSmoother.smooth(steps);
    assertEquals(4, smoothed.size());
    assertEquals(before, smoothed.get(1));
    assertTrue(smoothed.get(2).value(0) > 50);
  }
}
