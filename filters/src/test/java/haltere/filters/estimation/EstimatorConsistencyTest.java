package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.estimation.motion.DampedOscillator;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every estimator is consistent on data of its own model. */
class EstimatorConsistencyTest {
  private static final int RUNS = 200;
  private static final int STEPS = 60;

  /** A filter, and the world that it believes in. */
  record World(
      String name,
      Subject filter,
      ProcessModel process,
      MeasurementModel measurement,
      DMatrixRMaj x0,
      DMatrixRMaj p0,
      double dtS) {
    @Override
    public String toString() {
      return name;
    }
  }

  /** A damped oscillator that a white noise drives in each step, of all entries but the first. */
  private static final class DrivenOscillator implements ProcessModel {
    private final DampedOscillator motion = new DampedOscillator(Double.POSITIVE_INFINITY);

    @Override
    public int stateSize() {
      return 4;
    }

    @Override
    public void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
      motion.evolve(x, dtS, evolved);
    }

    @Override
    public void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f) {
      motion.jacobian(x, dtS, f);
    }

    @Override
    public void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
      q.setTo(Matrices.diagonal(20 * dtS * dtS * dtS / 3, 20 * dtS, 1e-4 * dtS, 1e-3 * dtS));
    }
  }

  static List<World> worlds() {
    DMatrixRMaj x2 = Matrices.column(1, -3);
    DMatrixRMaj p2 = Matrices.diagonal(4, 9);
    DMatrixRMaj x3 = Matrices.column(1, -3, 2);
    DMatrixRMaj p3 = Matrices.diagonal(4, 9, 25);
    DMatrixRMaj x4 = Matrices.column(60, 0, 60, 0);
    DMatrixRMaj p4 = Matrices.diagonal(2, 1e4, 2, 1e4);
    LinearMeasurement position2 = LinearMeasurement.ofEntries(2, 0.3, 0);
    LinearMeasurement position3 = LinearMeasurement.ofEntries(3, 0.3, 0);
    LinearMeasurement position = LinearMeasurement.ofEntries(4, 2, 0, 2);
    AxisMotion line = AxisMotion.constantVelocity(1, 2);
    AxisMotion plane = AxisMotion.constantVelocity(2, 5e3);
    AxisMotion jerk = AxisMotion.whiteJerk(1, 40);
    AxisMotion fall = AxisMotion.constantAcceleration(1, 0.5);
    double[] wing = {0.02, 0.5, 2, 8000};
    DMatrixRMaj xWing = Matrices.column(1.5, 1.1, 0.3, 1250);
    DMatrixRMaj pWing = Matrices.diagonal(0.01, 0.01, 0.05, 400);
    WingEdge.Angle angle = new WingEdge.Angle(0.006, Gate.OPEN);
    ProcessModel spring = new DrivenOscillator();
    DMatrixRMaj xSpring = Matrices.column(10, 0, 0.1, 5);
    DMatrixRMaj pSpring = Matrices.diagonal(1, 1, 1e-4, 0.01);
    LinearMeasurement displacement = LinearMeasurement.ofEntries(4, 0.04, 0);
    return List.of(
        new World(
            "constant velocity",
            Subject.of(new KalmanFilter(line, x2, p2), position2),
            line,
            position2,
            x2,
            p2,
            0.1),
        new World(
            "constant velocity in a plane",
            Subject.of(new KalmanFilter(plane, x4, p4), position),
            plane,
            position,
            x4,
            p4,
            0.01),
        new World(
            "white jerk",
            Subject.of(new KalmanFilter(jerk, x3, p3), position3),
            jerk,
            position3,
            x3,
            p3,
            0.1),
        new World(
            "constant acceleration",
            Subject.of(new KalmanFilter(fall, x3, p3), position3),
            fall,
            position3,
            x3,
            p3,
            0.1),
        new World(
            "wing edge, extended",
            Subject.of(new KalmanFilter(new WingEdge(wing), xWing, pWing), angle),
            new WingEdge(wing),
            angle,
            xWing,
            pWing,
            1e-4),
        new World(
            "wing edge, kernel alone",
            Subject.ofKernel(0.006, wing),
            new WingEdge(wing),
            angle,
            xWing,
            pWing,
            1e-4),
        new World(
            "damped oscillator",
            Subject.of(new KalmanFilter(spring, xSpring, pSpring), displacement),
            spring,
            displacement,
            xSpring,
            pSpring,
            0.02));
  }

  @ParameterizedTest
  @MethodSource("worlds")
  void neesAndNisLieInTheirBands(World world) {
    Verdict verdict = judge(world, world.measurement());
    int n = world.process().stateSize();
    int m = world.measurement().size();
    Interval neesBand = Consistency.meanBand(n, RUNS, 0.95);
    Interval nisBand = Consistency.meanBand(m, RUNS * STEPS, 0.95);
    Interval white = Whiteness.band(RUNS * STEPS, 0.95);
    assertTrue(neesBand.contains(verdict.nees), "NEES " + verdict.nees + " in " + neesBand);
    assertTrue(nisBand.contains(verdict.nis), "NIS " + verdict.nis + " in " + nisBand);
    assertTrue(white.contains(verdict.lagOne), "lag one " + verdict.lagOne + " in " + white);
  }

  @Test
  void filterWithTooSmallMeasurementNoiseIsInconsistent() {
    World world = worlds().get(0);
    Verdict verdict = judge(world, LinearMeasurement.ofEntries(2, 0.5, 0));
    assertFalse(Consistency.meanBand(2, RUNS, 0.95).contains(verdict.nees));
    assertFalse(Consistency.meanBand(1, RUNS * STEPS, 0.95).contains(verdict.nis));
    assertFalse(Whiteness.band(RUNS * STEPS, 0.95).contains(verdict.lagOne));
  }

  private record Verdict(double nees, double nis, double lagOne) {}

  /** Mean NEES at the end, mean NIS of all, and autocorrelation of the first innovation. */
  private static Verdict judge(World world, MeasurementModel nature) {
    Subject filter = world.filter();
    int m = nature.size();
    int n = world.process().stateSize();
    double nees = 0;
    double nis = 0;
    double[] innovations = new double[RUNS * STEPS];
    for (int run = 0; run < RUNS; run++) {
      Draws draws = new Draws(1000 + run);
      DMatrixRMaj truth = world.x0().copy();
      CommonOps_DDRM.addEquals(truth, draws.normal(world.p0()));
      filter.launch(world.x0(), world.p0());
      for (int k = 0; k < STEPS; k++) {
        double dtS = world.dtS() * draws.uniform(0.2, 1.8);
        DMatrixRMaj next = new DMatrixRMaj(n, 1);
        DMatrixRMaj q = new DMatrixRMaj(n, n);
        world.process().evolve(truth, dtS, next);
        world.process().noise(truth, dtS, q);
        CommonOps_DDRM.add(next, draws.normal(q), truth);
        DMatrixRMaj r = new DMatrixRMaj(m, m);
        DMatrixRMaj z = new DMatrixRMaj(m, 1);
        nature.noise(truth, r);
        nature.expected(truth, z);
        CommonOps_DDRM.addEquals(z, draws.normal(r));
        filter.predict(dtS);
        Innovation innovation = new Innovation();
        assertTrue(innovation.compute(world.measurement(), z, filter.state(), filter.covariance()));
        nis += innovation.nis / (RUNS * STEPS);
        innovations[run * STEPS + k] = innovation.y.get(0) / Math.sqrt(innovation.s.get(0, 0));
        filter.update(z);
      }
      DMatrixRMaj error = filter.state();
      CommonOps_DDRM.subtractEquals(error, truth);
      nees += Consistency.nees(error, filter.covariance()) / RUNS;
    }
    return new Verdict(nees, nis, Whiteness.lagOneAutocorrelation(innovations));
  }
}
