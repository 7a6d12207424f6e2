package haltere.filters.track.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.CholeskyDecomposition_F64;
import org.junit.jupiter.api.Test;

/** Vehicles that brake and speed up along a road. */
class AlongAccelerationTest {
  private static final int RUNS = 200;
  private static final int STEPS = 60;
  private static final int SETTLED = 10;
  private static final double SD_M = 0.1;
  private static final double ACROSS = 6;

  /** Place, speed and acceleration along the road among the states. */
  private static final int[] ALONG = {1, 3, 4};

  private final AlongAcceleration along = new AlongAcceleration(3, 2);
  private final SplittableRandom random = new SplittableRandom(12);

  private static PlaneFilter filter(double speed, double acceleration) {
    PlaneFilter filter = new PlaneFilter();
    filter.launch(2, 30, 0.5, 0.1, 0.3, 4, 9);
    filter.x[3] = speed;
    filter.x[4] = acceleration;
    return filter;
  }

  private static DMatrixRMaj covariance(PlaneFilter filter) {
    DMatrixRMaj matrix = new DMatrixRMaj(PlaneFilter.STATES, PlaneFilter.STATES);
    for (int i = 0; i < PlaneFilter.STATES; i++) {
      for (int j = 0; j < PlaneFilter.STATES; j++) {
        matrix.set(i, j, filter.covariance(i, j));
      }
    }
    return matrix;
  }

  /** Singer's transition over a time. */
  private DMatrixRMaj transition(double dtS) {
    double tau = along.keptS();
    double kept = Math.exp(-dtS / tau);
    DMatrixRMaj f = CommonOps_DDRM.identity(PlaneFilter.STATES);
    f.set(0, 2, dtS);
    f.set(1, 3, dtS);
    f.set(1, 4, tau * tau * (kept - 1 + dtS / tau));
    f.set(3, 4, tau * (1 - kept));
    f.set(4, 4, kept);
    return f;
  }

  @Test
  void stateAndCovarianceEvolveByTheMatrixOfTheModel() {
    PlaneFilter filter = filter(15, -3);
    // Entries beside the diagonal come about by what happens.
    for (int k = 0; k < 5; k++) {
      along.evolve(filter, 0.1);
      along.addNoise(filter, 0.1, ACROSS);
      filter.innovate(filter.x[0] + 0.3, filter.x[1] - 0.2, 0.4, 0.1, 0.2);
      filter.correct();
    }
    DMatrixRMaj f = transition(0.3);
    DMatrixRMaj state = new DMatrixRMaj(filter.x.clone());
    DMatrixRMaj expected = new DMatrixRMaj(PlaneFilter.STATES, 1);
    CommonOps_DDRM.mult(f, state, expected);
    DMatrixRMaj fp = new DMatrixRMaj(PlaneFilter.STATES, PlaneFilter.STATES);
    DMatrixRMaj fpf = new DMatrixRMaj(PlaneFilter.STATES, PlaneFilter.STATES);
    CommonOps_DDRM.mult(f, covariance(filter), fp);
    CommonOps_DDRM.multTransB(fp, f, fpf);
    along.evolve(filter, 0.3);
    for (int i = 0; i < PlaneFilter.STATES; i++) {
      assertEquals(expected.get(i), filter.x[i], 1e-9);
      for (int j = 0; j < PlaneFilter.STATES; j++) {
        assertEquals(fpf.get(i, j), filter.covariance(i, j), 1e-9, i + ", " + j);
      }
    }
  }

  @Test
  void aVehicleThatBrakesStandsInTheEndAndDoesNotGoBack() {
    for (int direction = -1; direction <= 1; direction += 2) {
      PlaneFilter filter = filter(direction * 4, -direction * 4);
      double last = filter.x[1];
      for (int k = 0; k < 300; k++) {
        along.evolve(filter, 0.01);
        assertTrue(direction * (filter.x[1] - last) >= -1e-12, "it goes back");
        last = filter.x[1];
      }
      assertEquals(0, filter.x[3]);
      assertEquals(2, direction * (filter.x[1] - 30), 0.7);
    }
  }

  @Test
  void twoMeasuredSpeedsAreWorthAsMuchAsTheirMeanOfHalfTheVariance() {
    PlaneFilter twice = filter(15, -3);
    along.evolve(twice, 0.4);
    PlaneFilter once = new PlaneFilter();
    once.copyFrom(twice);
    double certainty = 1 / twice.covariance(3, 3);
    twice.correctAlong(13, 0.8);
    twice.correctAlong(14, 0.8);
    once.correctAlong(13.5, 0.4);
    assertEquals(certainty + 2.5, 1 / twice.covariance(3, 3), 1e-9);
    for (int i = 0; i < PlaneFilter.STATES; i++) {
      assertEquals(once.x[i], twice.x[i], 1e-9);
      for (int j = 0; j < PlaneFilter.STATES; j++) {
        assertEquals(once.covariance(i, j), twice.covariance(i, j), 1e-9);
      }
    }
  }

  @Test
  void errorsAndInnovationsLieInTheirBands() {
    double nees = 0;
    double nis = 0;
    int innovations = 0;
    for (int run = 0; run < RUNS; run++) {
      PlaneFilter filter = new PlaneFilter();
      // Far from standing, where the model is linear.
      double[] truth = {0, 1000 + 5 * random.nextGaussian(), 3 * random.nextGaussian()};
      filter.launch(0, 0, 1, 0, 1e-6, 25, 9);
      filter.x[3] = 1000;
      for (int k = 0; k < STEPS; k++) {
        double dtS = random.nextDouble(0.02, 0.3);
        move(truth, dtS);
        along.evolve(filter, dtS);
        along.addNoise(filter, dtS, 0);
        double measured = truth[0] + SD_M * random.nextGaussian();
        filter.innovate(random.nextGaussian(), measured, 1, 0, SD_M * SD_M);
        filter.correct();
        if (k >= SETTLED) {
          double s = filter.innovationYy();
          nis += filter.innovationY() * filter.innovationY() / s;
          innovations++;
        }
      }
      nees += nees(filter, truth);
    }
    assertIn(Consistency.meanBand(3, RUNS, 0.95), nees / RUNS, "NEES");
    assertIn(Consistency.meanBand(1, innovations, 0.95), nis / innovations, "NIS");
  }

  private static void assertIn(Interval band, double value, String what) {
    assertTrue(band.lower() <= value && value <= band.upper(), what + " " + value + " in " + band);
  }

  private static double nees(PlaneFilter filter, double[] truth) {
    DMatrixRMaj error = new DMatrixRMaj(3, 1);
    DMatrixRMaj covariance = new DMatrixRMaj(3, 3);
    for (int i = 0; i < 3; i++) {
      error.set(i, filter.x[ALONG[i]] - truth[i]);
      for (int j = 0; j < 3; j++) {
        covariance.set(i, j, filter.covariance(ALONG[i], ALONG[j]));
      }
    }
    return Consistency.nees(error, covariance);
  }

  /** Draws what the model may do in a time. */
  private void move(double[] truth, double dtS) {
    PlaneFilter noise = new PlaneFilter();
    along.addNoise(noise, dtS, 0);
    DMatrixRMaj q = new DMatrixRMaj(3, 3);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        q.set(i, j, noise.covariance(ALONG[i], ALONG[j]));
      }
    }
    CholeskyDecomposition_F64<DMatrixRMaj> cholesky = DecompositionFactory_DDRM.chol(3, true);
    assertTrue(cholesky.decompose(q.copy()), "noise is no covariance");
    DMatrixRMaj root = cholesky.getT(null);
    DMatrixRMaj f = transition(dtS);
    double[] before = truth.clone();
    double[] draws = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
    for (int i = 0; i < 3; i++) {
      truth[i] = 0;
      for (int j = 0; j < 3; j++) {
        truth[i] += f.get(ALONG[i], ALONG[j]) * before[j] + root.get(i, j) * draws[j];
      }
    }
  }
}
