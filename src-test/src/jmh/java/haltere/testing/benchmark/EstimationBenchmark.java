package haltere.testing.benchmark;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.ConstantVelocityPlane;
import haltere.filters.estimation.CovarianceForm;
import haltere.filters.estimation.ExtendedKalmanFilter;
import haltere.filters.estimation.FilterOptions;
import haltere.filters.estimation.FourStateEkf;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.LinearMeasurement;
import haltere.filters.estimation.LinearProcessModel;
import haltere.filters.estimation.MeasurementModel;
import haltere.filters.estimation.SineCosine;
import haltere.filters.estimation.UpdateOutcome;
import haltere.filters.estimation.motion.ConstantVelocity;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One prediction and one update, in ns: the written-out filters beside the clear ones on matrices.
 * The wing's cost includes a sine and a cosine; {@code waveAlone} is these two.
 *
 * <p>To hold: an update of the written-out extended filter of four states, with its prediction, in
 * at most 60 ns, and no allocation.
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=EstimationBenchmark -PjmhArgs='-prof gc'}
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class EstimationBenchmark {
  private static final int EVENTS = 4096;
  private static final double DT_S = 5e-6;
  private static final double Q_CENTRE = 0.02 * DT_S;
  private static final double Q_AMPLITUDE = 0.5 * DT_S;
  private static final double Q_PHASE = 2 * DT_S;
  private static final double Q_FREQUENCY = 8000 * DT_S;
  private static final double R = 0.006;

  private final double[] noise = new double[EVENTS];
  private final DMatrixRMaj scalar = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj pair = new DMatrixRMaj(2, 1);
  private final LinearMeasurement place = LinearMeasurement.ofEntries(4, 2, 0, 2);
  private final Wing wing = new Wing();
  private final SineCosine wave = new SineCosine();
  private ConstantVelocityPlane plane;
  private KalmanFilter planeClear;
  private FourStateEkf edge;
  private ExtendedKalmanFilter edgeClear;
  private ExtendedKalmanFilter edgeUd;
  private double phase;
  private int next;

  /** Launches all filters. */
  @Setup
  public void launch() {
    Random random = new Random(1);
    for (int i = 0; i < EVENTS; i++) {
      noise[i] = random.nextGaussian();
    }
    plane = new ConstantVelocityPlane(1e4, Gate.sigmas(5), 20);
    plane.launch(0, 0, 4, 1e4);
    planeClear =
        new KalmanFilter(
            new ConstantVelocity(2, 1e4),
            new DMatrixRMaj(4, 1),
            CommonOps_DDRM.diag(4, 1e4, 4, 1e4));
    edge = new FourStateEkf(Gate.sigmas(5), 20);
    edge.setState(1.5, 1, 0, 1250);
    edge.setVariances(0.1, 0.1, 0.1, 400);
    DMatrixRMaj x = new DMatrixRMaj(4, 1, true, 1.5, 1, 0, 1250);
    DMatrixRMaj p = CommonOps_DDRM.diag(0.1, 0.1, 0.1, 400);
    edgeClear = new ExtendedKalmanFilter(wing, x, p);
    edgeUd =
        new ExtendedKalmanFilter(wing, x, p, FilterOptions.DEFAULT.withForm(CovarianceForm.UD));
  }

  private double noise() {
    next = (next + 1) & (EVENTS - 1);
    return noise[next];
  }

  private double angle() {
    phase = Angles.wrapPi(phase + 1250 * DT_S);
    // Not a sine, so that what is measured is the filter's own.
    return 1.5 + phase * (4 / Math.PI - 4 / (Math.PI * Math.PI) * Math.abs(phase)) + 0.07 * noise();
  }

  /**
   * A place, written out.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome planeWrittenOut() {
    plane.predict(DT_S);
    return plane.update(noise(), noise(), 2);
  }

  /**
   * A place, on matrices.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome planeClear() {
    planeClear.predict(DT_S);
    pair.set(0, 0, noise());
    pair.set(1, 0, noise());
    return planeClear.update(place, pair);
  }

  /**
   * A wing's edge, written out.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome edgeWrittenOut() {
    edge.predict(0, 0, 0, 0, 0, DT_S);
    edge.addNoise(Q_CENTRE, Q_AMPLITUDE, Q_PHASE, Q_FREQUENCY);
    wave.of(edge.x2());
    double sin = wave.sine();
    double y = Angles.wrapPi(angle() - (edge.x0() + edge.x1() * sin));
    UpdateOutcome outcome = edge.update(y, 1, sin, edge.x1() * wave.cosine(), 0, R);
    if (edge.x2() > Math.PI) {
      // As the wing tracker does; a phase of many turns would need the slower sine.
      edge.setState(edge.x0(), edge.x1(), edge.x2() - 2 * Math.PI, edge.x3());
    }
    return outcome;
  }

  /**
   * A wing's edge, written out, with sine and cosine taken as known: the filter's own arithmetic.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome edgeWrittenOutWithoutWave() {
    edge.predict(0, 0, 0, 0, 0, DT_S);
    edge.addNoise(Q_CENTRE, Q_AMPLITUDE, Q_PHASE, Q_FREQUENCY);
    double sin = 0.1 * noise();
    return edge.update(0.07 * noise(), 1, sin, 0.9, 0, R);
  }

  /**
   * Sine and cosine alone.
   *
   * @return their sum
   */
  @Benchmark
  public double waveAlone() {
    phase = Angles.wrapPi(phase + 1250 * DT_S);
    wave.of(phase);
    return wave.sine() + wave.cosine();
  }

  /**
   * A wing's edge, on matrices, Joseph's form.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome edgeClear() {
    scalar.set(0, 0, angle());
    edgeClear.predict(DT_S);
    return edgeClear.update(wing, scalar);
  }

  /**
   * A wing's edge, on matrices, UD factors.
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome edgeUd() {
    scalar.set(0, 0, angle());
    edgeUd.predict(DT_S);
    return edgeUd.update(wing, scalar);
  }

  /** State (a, M, ξ, ω), measured angle a + M sin ξ. */
  private static final class Wing implements LinearProcessModel, MeasurementModel {
    @Override
    public int stateSize() {
      return 4;
    }

    @Override
    public void transition(double dtS, DMatrixRMaj f) {
      CommonOps_DDRM.setIdentity(f);
      f.set(2, 3, dtS);
    }

    @Override
    public void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
      evolved.setTo(x);
      evolved.add(2, 0, dtS * x.get(3));
    }

    @Override
    public void noise(double dtS, DMatrixRMaj q) {
      q.zero();
      q.set(0, 0, 0.02 * dtS);
      q.set(1, 1, 0.5 * dtS);
      q.set(2, 2, 2 * dtS);
      q.set(3, 3, 8000 * dtS);
    }

    @Override
    public void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
      noise(dtS, q);
    }

    @Override
    public int size() {
      return 1;
    }

    @Override
    public void expected(DMatrixRMaj x, DMatrixRMaj z) {
      z.set(0, 0, x.get(0) + x.get(1) * Math.sin(x.get(2)));
    }

    @Override
    public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
      h.set(0, 0, 1);
      h.set(0, 1, Math.sin(x.get(2)));
      h.set(0, 2, x.get(1) * Math.cos(x.get(2)));
      h.set(0, 3, 0);
    }

    @Override
    public void noise(DMatrixRMaj x, DMatrixRMaj r) {
      r.set(0, 0, R);
    }

    @Override
    public void residual(DMatrixRMaj z, DMatrixRMaj expected, DMatrixRMaj y) {
      y.set(0, 0, Angles.wrapPi(z.get(0) - expected.get(0)));
    }
  }
}
