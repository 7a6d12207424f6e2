package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.assertClose;
import static haltere.filters.estimation.Matrices.assertSameCovariance;
import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.covarianceOf;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.FilterStep.Correction;
import haltere.filters.estimation.FilterStep.Launch;
import haltere.filters.estimation.FilterStep.Prediction;
import haltere.filters.estimation.motion.AxisMotion;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KalmanFilterTest {
  @Test
  void filterWithoutProcessNoiseEqualsTheBatchFit() {
    Draws draws = new Draws(11);
    double dtS = 0.013;
    double variance = 0.04;
    DMatrixRMaj launch = column(1, -2, 3);
    DMatrixRMaj p0 = diagonal(4, 9, 25);
    KalmanFilter filter = new KalmanFilter(AxisMotion.constantAcceleration(1, 0), launch, p0);
    LinearMeasurement position = LinearMeasurement.ofEntries(3, variance, 0);
    // Information form of the fit, in terms of the state at the end.
    DMatrixRMaj information = new DMatrixRMaj(3, 3);
    DMatrixRMaj right = new DMatrixRMaj(3, 1);
    int n = 60;
    double endS = (n - 1) * dtS;
    double[][] prior = {{1, -endS, endS * endS / 2}, {0, 1, -endS}, {0, 0, 1}};
    for (int i = 0; i < 3; i++) {
      addObservation(information, right, prior[i], launch.get(i), p0.get(i, i));
    }
    for (int k = 0; k < n; k++) {
      if (k > 0) {
        filter.predict(dtS);
      }
      double z = 5 - 3 * k * dtS + draws.normal(0.2);
      filter.update(position, z);
      double t = k * dtS - endS;
      addObservation(information, right, new double[] {1, t, t * t / 2}, z, variance);
    }
    DMatrixRMaj fitted = new DMatrixRMaj(3, 1);
    DMatrixRMaj covariance = new DMatrixRMaj(3, 3);
    assertTrue(CommonOps_DDRM.solve(information, right, fitted));
    assertTrue(CommonOps_DDRM.invert(information, covariance));
    assertClose(fitted, filter.estimate().state().toMatrix(), 1e-9);
    assertSameCovariance(covariance, covarianceOf(filter), 1e-9);
  }

  private static void addObservation(
      DMatrixRMaj information, DMatrixRMaj right, double[] row, double z, double variance) {
    for (int i = 0; i < row.length; i++) {
      right.add(i, 0, row[i] * z / variance);
      for (int j = 0; j < row.length; j++) {
        information.add(i, j, row[i] * row[j] / variance);
      }
    }
  }

  /**
   * F = H = Q = R = 1: Benavoli, Chisci and Farina (2009), "Fibonacci sequence, golden section,
   * Kalman filter and optimal control".
   */
  @Test
  void randomWalkWithEqualNoiseHasTheGoldenRatioAsGain() {
    LinearProcessModel walk = new RandomWalk();
    List<Correction> corrections = new ArrayList<>();
    KalmanFilter filter = new KalmanFilter(walk, column(0), diagonal(1));
    filter.observe(step -> keep(step, corrections));
    LinearMeasurement itself = LinearMeasurement.ofEntries(1, 1, 0);
    for (int k = 0; k < 60; k++) {
      filter.predict(1);
      filter.update(itself, 0);
    }
    double golden = (Math.sqrt(5) - 1) / 2;
    assertEquals(golden, corrections.get(59).gain().get(0), 1e-14);
    assertEquals(1 + golden, corrections.get(59).prior().covariance().get(0), 1e-14);
  }

  private static void keep(FilterStep step, List<Correction> corrections) {
    if (step instanceof Correction c) {
      corrections.add(c);
    }
  }

  private static final class RandomWalk implements LinearProcessModel {
    @Override
    public int stateSize() {
      return 1;
    }

    @Override
    public void transition(double dtS, DMatrixRMaj f) {
      f.set(0, 0, 1);
    }

    @Override
    public void noise(double dtS, DMatrixRMaj q) {
      q.set(0, 0, dtS);
    }
  }

  /**
   * Kalata (1984), "The tracking index"; Bar-Shalom, Li and Kirubarajan (2001), eq. 6.5.3-11 to
   * -15: the steady gains of position and velocity under piecewise constant white acceleration.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.01, 0.1, 1, 10})
  void steadyGainsMatchTheAlphaBetaFilter(double index) {
    double dtS = 0.5;
    LinearProcessModel model = new PiecewiseAcceleration(index / (dtS * dtS));
    List<Correction> corrections = new ArrayList<>();
    KalmanFilter filter = new KalmanFilter(model, column(0, 0), diagonal(1, 1));
    filter.observe(step -> keep(step, corrections));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1, 0);
    for (int k = 0; k < 2000; k++) {
      filter.predict(dtS);
      filter.update(position, 0);
    }
    double root = Math.sqrt(index * index + 8 * index);
    double alpha = -(index * index + 8 * index - (index + 4) * root) / 8;
    double beta = (index * index + 4 * index - index * root) / 4;
    ConstMatrix gain = corrections.get(corrections.size() - 1).gain();
    assertEquals(alpha, gain.get(0), 1e-11);
    assertEquals(beta / dtS, gain.get(1), 1e-11);
  }

  /** Acceleration constant over each step, of a given standard deviation. */
  private record PiecewiseAcceleration(double standardDeviation) implements LinearProcessModel {
    @Override
    public int stateSize() {
      return 2;
    }

    @Override
    public void transition(double dtS, DMatrixRMaj f) {
      AxisMotion.constantVelocity(1, 0).jacobian(column(0, 0), dtS, f);
    }

    @Override
    public void noise(double dtS, DMatrixRMaj q) {
      double s = standardDeviation * dtS * dtS / 2;
      double v = standardDeviation * dtS;
      q.set(0, 0, s * s);
      q.set(0, 1, s * v);
      q.set(1, 0, s * v);
      q.set(1, 1, v * v);
    }
  }

  @Test
  void correlatedNoiseMatchesTheTextbook() {
    Draws draws = new Draws(8);
    for (int run = 0; run < 50; run++) {
      DMatrixRMaj x = draws.normal(diagonal(1, 1, 1));
      DMatrixRMaj p = draws.covariance(3);
      DMatrixRMaj h = new DMatrixRMaj(2, 3);
      for (int i = 0; i < 6; i++) {
        h.set(i, draws.normal(1));
      }
      LinearMeasurement m = new LinearMeasurement(h, draws.covariance(2), Gate.OPEN);
      AxisMotion jerk = AxisMotion.whiteJerk(1, 2);
      KalmanFilter filter = new KalmanFilter(jerk, x, p);
      Textbook textbook = new Textbook(x, p);
      for (int k = 0; k < 20; k++) {
        filter.predict(0.2);
        textbook.predict(jerk, 0.2);
        DMatrixRMaj z = draws.normal(diagonal(1, 1));
        filter.update(m, z);
        textbook.update(m, z);
      }
      assertClose(textbook.x, filter.estimate().state().toMatrix(), 1e-9);
      assertSameCovariance(textbook.p, covarianceOf(filter), 1e-9);
    }
  }

  @Test
  void observedIntermediatesSatisfyTheEquations() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 2), column(1, 3), diagonal(4, 9));
    List<FilterStep> steps = new ArrayList<>();
    filter.observe(steps::add);
    filter.predict(0.5);
    filter.update(LinearMeasurement.ofEntries(2, 0.7, 0), 4);
    Launch launch = (Launch) steps.get(0);
    Prediction prediction = (Prediction) steps.get(1);
    Correction correction = (Correction) steps.get(2);
    assertEquals(1, launch.estimate().value(0));
    assertEquals(0.5, prediction.dtS());
    assertEquals(0.5, prediction.estimate().timeS());
    assertClose(
        Matrices.propagated(
            prediction.transition().toMatrix(), diagonal(4, 9), prediction.noise().toMatrix()),
        prediction.estimate().covariance().toMatrix(),
        1e-15);
    assertEquals(prediction.estimate(), correction.prior());
    assertEquals(4 - 2.5, correction.innovation().get(0), 1e-15);
    double p00 = correction.prior().covariance().get(0, 0);
    double s = correction.innovationCovariance().get(0);
    assertEquals(p00 + 0.7, s, 1e-14);
    assertEquals(p00 / s, correction.gain().get(0), 1e-15);
    assertEquals(1.5 * 1.5 / s, correction.nis(), 1e-14);
    assertEquals(filter.estimate(), correction.estimate());
    assertEquals(Math.sqrt(filter.covariance(1, 1)), filter.estimate().standardDeviation(1));
    filter.observe(null);
    filter.predict(0.5);
    assertEquals(3, steps.size());
  }

  @Test
  void estimatesAreImmutable() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 2), column(1, 3), diagonal(4, 9));
    Estimate before = filter.estimate();
    before.covariance().toMatrix().set(0, 0, 77);
    filter.predict(1);
    assertEquals(4, before.covariance().get(0, 0));
    assertEquals(1, before.value(0));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1e-9, Double.NaN, Double.POSITIVE_INFINITY})
  void invalidTimeStepsAreRejected(double dtS) {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1), column(0, 0), diagonal(1, 1));
    assertThrows(IllegalArgumentException.class, () -> filter.predict(dtS));
  }

  @Test
  void zeroTimeStepChangesNothing() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1), column(0, 1), diagonal(1, 1));
    Estimate before = filter.estimate();
    filter.predict(0);
    assertEquals(before, filter.estimate());
  }

  @Test
  void covarianceStaysValidAfterAYearWithoutMeasurements() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1e6), column(0, 1), diagonal(1, 1));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1, 0);
    for (int i = 0; i < 365; i++) {
      filter.predict(86_400);
      assertEquals(UpdateOutcome.APPLIED, filter.update(position, 5));
    }
    assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(covarianceOf(filter)));
    assertEquals(5, filter.state(0), 1e-3);
  }

  @Test
  void invalidInitialStatesAreRejected() {
    AxisMotion model = AxisMotion.constantVelocity(1, 1);
    DMatrixRMaj x = column(0, 0);
    assertThrows(
        IllegalArgumentException.class,
        () -> new KalmanFilter(model, column(0, Double.NaN), diagonal(1, 1)));
    assertThrows(
        IllegalArgumentException.class, () -> new KalmanFilter(model, column(0), diagonal(1, 1)));
    assertThrows(IllegalArgumentException.class, () -> new KalmanFilter(model, x, diagonal(1, 0)));
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new KalmanFilter(
                model, x, Matrices.rows(new double[] {1, 0.5}, new double[] {0.4, 1})));
    assertThrows(
        IllegalArgumentException.class, () -> new KalmanFilter(model, x, diagonal(1, Double.NaN)));
    assertThrows(IllegalArgumentException.class, () -> AxisMotion.constantVelocity(0, 1));
    assertThrows(IllegalArgumentException.class, () -> AxisMotion.constantVelocity(1, -1));
    assertThrows(
        IllegalArgumentException.class, () -> LinearMeasurement.ofEntries(2, Double.NaN, 0));
    KalmanFilter filter = new KalmanFilter(model, x, diagonal(1, 1));
    assertThrows(
        IllegalArgumentException.class,
        () -> filter.update(LinearMeasurement.ofEntries(2, 1, 0), 1, 2));
  }
}
