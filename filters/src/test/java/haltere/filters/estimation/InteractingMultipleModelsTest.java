package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.ConstantVelocity;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;

class InteractingMultipleModelsTest {
  private static final double CALM = 0.05;
  private static final double WILD = 400;
  private static final double DT_S = 0.05;
  private static final double VARIANCE = 0.2;
  private static final ModeSwitching SWITCHING = ModeSwitching.meanStays(4, 2);
  private static final LinearMeasurement POSITION = LinearMeasurement.ofEntries(2, VARIANCE, 0);

  private static InteractingMultipleModels estimator() {
    return new InteractingMultipleModels(
        List.of(new ConstantVelocity(1, CALM), new ConstantVelocity(1, WILD)),
        SWITCHING,
        column(0, 0),
        diagonal(1, 25),
        FilterOptions.DEFAULT);
  }

  @Test
  void itBeatsEitherModelAloneAndItsModeProbabilitiesAreNearlyTrueOnes() {
    int runs = 150;
    int steps = 200;
    double[] square = new double[3];
    double nees = 0;
    double nis = 0;
    double[] said = new double[5];
    double[] happened = new double[5];
    int[] count = new int[5];
    for (int run = 0; run < runs; run++) {
      Draws draws = new Draws(run);
      Estimator calm =
          new KalmanFilter(new ConstantVelocity(1, CALM), column(0, 0), diagonal(1, 25));
      Estimator wild =
          new KalmanFilter(new ConstantVelocity(1, WILD), column(0, 0), diagonal(1, 25));
      InteractingMultipleModels both = estimator();
      List<Estimator> all = List.of(both, calm, wild);
      DMatrixRMaj truth = draws.normal(diagonal(1, 25));
      int mode = draws.uniform(0, 1) < 0.5 ? 0 : 1;
      DMatrixRMaj switching = SWITCHING.probabilities(DT_S);
      for (int k = 0; k < steps; k++) {
        mode = draws.uniform(0, 1) < switching.get(mode, 0) ? 0 : 1;
        truth = moved(truth, new ConstantVelocity(1, mode == 0 ? CALM : WILD), draws);
        DMatrixRMaj z = column(truth.get(0) + draws.normal(Math.sqrt(VARIANCE)));
        for (int i = 0; i < 3; i++) {
          all.get(i).predict(DT_S);
          if (all.get(i) == both) {
            double innovation = z.get(0) - both.state(0);
            nis += innovation * innovation / (both.covariance(0, 0) + VARIANCE) / (runs * steps);
          }
          all.get(i).update(POSITION, z);
          square[i] += Math.pow(all.get(i).state(0) - truth.get(0), 2);
        }
        nees += Consistency.nees(both.estimate(), truth.data) / (runs * steps);
        double probability = both.modeProbability(1);
        assertEquals(1, probability + both.modeProbability(0), 1e-12);
        int bin = Math.min(4, (int) (5 * probability));
        said[bin] += probability;
        happened[bin] += mode;
        count[bin]++;
      }
    }
    assertTrue(square[0] < 0.85 * square[1], "better than calm: " + square[0] + " " + square[1]);
    assertTrue(square[0] < 0.85 * square[2], "better than wild: " + square[0] + " " + square[2]);
    for (int bin = 0; bin < 5; bin++) {
      assertTrue(count[bin] > 200, "bin " + bin + " has " + count[bin]);
      assertEquals(said[bin] / count[bin], happened[bin] / count[bin], 0.06, "bin " + bin);
    }
    // The mixture is not Gaussian, so its NEES is only nearly chi-square.
    assertEquals(2, nees, 0.15);
    Interval band = Consistency.meanBand(1, runs * steps, 0.95);
    assertTrue(band.contains(nis), "NIS " + nis + " in " + band);
  }

  private static DMatrixRMaj moved(DMatrixRMaj truth, ConstantVelocity model, Draws draws) {
    DMatrixRMaj next = new DMatrixRMaj(2, 1);
    DMatrixRMaj q = new DMatrixRMaj(2, 2);
    model.evolve(truth, DT_S, next);
    model.noise(DT_S, q);
    CommonOps_DDRM.addEquals(next, draws.normal(q));
    return next;
  }

  @Test
  void ofTwoEqualModelsItIsThatModel() {
    Draws draws = new Draws(3);
    ConstantVelocity model = new ConstantVelocity(1, 3);
    KalmanFilter one = new KalmanFilter(model, column(0, 0), diagonal(1, 25));
    InteractingMultipleModels two =
        new InteractingMultipleModels(
            List.of(model, model, model),
            ModeSwitching.meanStays(1, 2, 3),
            column(0, 0),
            diagonal(1, 25),
            FilterOptions.DEFAULT);
    for (int k = 0; k < 100; k++) {
      one.predict(0.1);
      two.predict(0.1);
      double z = draws.normal(1);
      one.update(POSITION, z);
      two.update(POSITION, z);
      assertEquals(one.logLikelihood(), two.logLikelihood(), 1e-9);
    }
    Matrices.assertClose(
        one.estimate().state().toMatrix(), two.estimate().state().toMatrix(), 1e-11);
    Matrices.assertSameCovariance(Matrices.covarianceOf(one), Matrices.covarianceOf(two), 1e-11);
  }

  @Test
  void aModeIsNeverLostHoweverImprobableItBecame() {
    InteractingMultipleModels estimator = estimator();
    for (int k = 0; k < 400; k++) {
      estimator.predict(DT_S);
      estimator.update(POSITION, 0);
    }
    // A jump of a thousand standard deviations: the likelihood of either underflows as a number.
    assertTrue(estimator.modeProbability(1) < 0.1);
    estimator.predict(DT_S);
    estimator.update(POSITION, 1000);
    assertTrue(estimator.modeProbability(1) > 0.999);
    for (int k = 1; k < 40; k++) {
      estimator.predict(DT_S);
      assertEquals(UpdateOutcome.APPLIED, estimator.update(POSITION, 1000 + 30 * k));
    }
    assertEquals(1000 + 30 * 39, estimator.state(0), 5);
  }

  @Test
  void aGateIsPassedByAllModesOrByNone() {
    InteractingMultipleModels estimator =
        new InteractingMultipleModels(
            List.of(new ConstantVelocity(1, CALM), new ConstantVelocity(1, WILD)),
            SWITCHING,
            column(0, 0),
            diagonal(1e-3, 1e-3),
            FilterOptions.DEFAULT.withLossAfter(2));
    LinearMeasurement gated = POSITION.withGate(Gate.sigmas(3));
    estimator.predict(DT_S);
    Estimate before = estimator.estimate();
    double probability = estimator.modeProbability(0);
    assertEquals(UpdateOutcome.GATED, estimator.update(gated, 100));
    assertEquals(UpdateOutcome.UNUSABLE, estimator.update(gated, Double.NaN));
    assertEquals(UpdateOutcome.LOCK_LOST, estimator.update(gated, 100));
    assertEquals(before, estimator.estimate());
    assertEquals(probability, estimator.modeProbability(0));
    assertEquals(UpdateOutcome.APPLIED, estimator.update(gated, 0.1));
    assertFalse(estimator.monitor().lockLost());
  }

  @Test
  void anHourOfSilenceLeavesNoRunawayCovariance() {
    InteractingMultipleModels capped = estimator();
    capped.predict(3600);
    InteractingMultipleModels tenSeconds = estimator();
    tenSeconds.predict(10);
    assertEquals(tenSeconds.covariance(0, 0), capped.covariance(0, 0));
    InteractingMultipleModels anew =
        new InteractingMultipleModels(
            List.of(new ConstantVelocity(1, CALM), new ConstantVelocity(1, WILD)),
            SWITCHING,
            column(2, 0),
            diagonal(1, 25),
            FilterOptions.DEFAULT.withGap(GapPolicy.relaunch(1)));
    anew.predict(0.5);
    anew.update(POSITION, 7);
    anew.predict(3600);
    assertEquals(1, anew.relaunches());
    assertEquals(2, anew.state(0), 1e-12);
    assertEquals(25, anew.covariance(1, 1), 1e-12);
    assertEquals(0.5, anew.modeProbability(0), 1e-12);
    assertThrows(IllegalArgumentException.class, () -> anew.predict(-1));
  }

  @Test
  void switchingForALongTimeIsSwitchingOften() {
    ModeSwitching stays = ModeSwitching.meanStays(0.5, 2, 1);
    DMatrixRMaj step = stays.probabilities(0.01);
    DMatrixRMaj product = CommonOps_DDRM.identity(3);
    DMatrixRMaj next = new DMatrixRMaj(3, 3);
    for (int i = 0; i < 150; i++) {
      CommonOps_DDRM.mult(product, step, next);
      product.setTo(next);
    }
    Matrices.assertClose(product, stays.probabilities(1.5), 1e-12);
    // Two modes have a closed form: the stay probability falls to its share with the sum of rates.
    DMatrixRMaj two = ModeSwitching.meanStays(2, 0.5).probabilities(0.3);
    double sum = 0.5 + 2;
    assertEquals((2 + 0.5 * Math.exp(-sum * 0.3)) / sum, two.get(0, 0), 1e-13);
    assertEquals((0.5 + 2 * Math.exp(-sum * 0.3)) / sum, two.get(1, 1), 1e-13);
    DMatrixRMaj ages = ModeSwitching.meanStays(1e-6, 1e-6).probabilities(1e9);
    assertEquals(0.5, ages.get(0, 1), 1e-12);
  }

  @Test
  void modelsAndSwitchingThatDoNotFitAreRefused() {
    List<ConstantVelocity> line = List.of(new ConstantVelocity(1, 1), new ConstantVelocity(1, 2));
    List<ConstantVelocity> mixed = List.of(new ConstantVelocity(1, 1), new ConstantVelocity(2, 2));
    FilterOptions options = FilterOptions.DEFAULT;
    DMatrixRMaj x = column(0, 0);
    DMatrixRMaj p = diagonal(1, 1);
    assertThrows(
        IllegalArgumentException.class,
        () -> new InteractingMultipleModels(line, ModeSwitching.meanStays(1, 1, 1), x, p, options));
    assertThrows(
        IllegalArgumentException.class,
        () -> new InteractingMultipleModels(mixed, SWITCHING, x, p, options));
    assertThrows(IllegalArgumentException.class, () -> ModeSwitching.meanStays(1, 0));
    assertThrows(IllegalArgumentException.class, () -> ModeSwitching.meanStays(1));
    assertThrows(
        IllegalArgumentException.class,
        () ->
            ModeSwitching.perStep(Matrices.rows(new double[] {0.9, 0.2}, new double[] {0.1, 0.9})));
  }
}
