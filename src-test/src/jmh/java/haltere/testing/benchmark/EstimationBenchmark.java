package haltere.testing.benchmark;

import haltere.filters.estimation.GaussianState;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.LinearMeasurement;
import haltere.filters.estimation.UpdateOutcome;
import haltere.filters.estimation.motion.AxisMotion;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.ejml.data.DMatrix4;
import org.ejml.data.DMatrix4x4;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.fixed.CommonOps_DDF4;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.mult.MatrixVectorMult_DDRM;
import org.ejml.dense.row.mult.VectorVectorMult_DDRM;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The loops of the estimation kernel beside the same arithmetic in EJML's operations, in ns: what
 * decision 13 rests on. A correction is a projection and a scalar update that restores P h = r K; a
 * prediction is one link of a chain of integrators with noise on one entry.
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
  private static final int ROWS = 1024;
  private static final double DT_S = 5e-6;

  /** States: an edge of a wing, an attitude with its rates, a wing with three harmonics. */
  @Param({"4", "7", "11"})
  public int size;

  private final double[][] rows = new double[ROWS][];
  private final DMatrixRMaj[] columns = new DMatrixRMaj[ROWS];
  private final DMatrix4[] fixedRows = new DMatrix4[ROWS];
  private final double[] innovations = new double[ROWS];
  private final LinearMeasurement position = LinearMeasurement.ofEntries(4, 2, 0, 2);
  private final DMatrixRMaj pair = new DMatrixRMaj(2, 1);
  private GaussianState kernel;
  private DMatrixRMaj x;
  private DMatrixRMaj p;
  private DMatrixRMaj work;
  private DMatrixRMaj transition;
  private DMatrixRMaj noise;
  private DMatrixRMaj g;
  private DMatrixRMaj e;
  private final DMatrix4x4 fixedP = new DMatrix4x4();
  private final DMatrix4x4 fixedWork = new DMatrix4x4();
  private final DMatrix4 fixedX = new DMatrix4();
  private final DMatrix4 fixedG = new DMatrix4();
  private final DMatrix4 fixedE = new DMatrix4();
  private KalmanFilter plane;
  private int next;

  /** Draws rows, innovations and a covariance. */
  @Setup
  public void draw() {
    Random random = new Random(1);
    for (int k = 0; k < ROWS; k++) {
      rows[k] = new double[size];
      for (int i = 0; i < size; i++) {
        rows[k][i] = random.nextGaussian();
      }
      columns[k] = DMatrixRMaj.wrap(size, 1, rows[k]);
      fixedRows[k] = new DMatrix4(rows[k][0], rows[k][1], rows[k][2], rows[k][3]);
      innovations[k] = random.nextGaussian();
    }
    kernel = new GaussianState(size);
    kernel.set(new DMatrixRMaj(size, 1), CommonOps_DDRM.identity(size));
    x = new DMatrixRMaj(size, 1);
    p = CommonOps_DDRM.identity(size);
    CommonOps_DDF4.setIdentity(fixedP);
    work = new DMatrixRMaj(size, size);
    transition = CommonOps_DDRM.identity(size);
    transition.set(2, 3, DT_S);
    noise = new DMatrixRMaj(size, size);
    noise.set(3, 3, 1e-3);
    g = new DMatrixRMaj(size, 1);
    e = new DMatrixRMaj(size, 1);
    DMatrixRMaj start = new DMatrixRMaj(4, 1);
    plane =
        new KalmanFilter(
            AxisMotion.constantVelocity(2, 1e4), start, CommonOps_DDRM.diag(4, 1e4, 4, 1e4));
  }

  private int next() {
    next = (next + 1) & (ROWS - 1);
    return next;
  }

  /**
   * A scalar correction by the kernel.
   *
   * @return the state
   */
  @Benchmark
  public double correctionByKernel() {
    int k = next();
    kernel.addNoise(k % size, 0.1);
    kernel.project(rows[k]);
    kernel.correct(innovations[k], 1);
    return kernel.mean(0);
  }

  /**
   * The same by EJML's operations on matrices of any size.
   *
   * @return the state
   */
  @Benchmark
  public double correctionByEjml() {
    int k = next();
    p.add(k % size, k % size, 0.1);
    DMatrixRMaj h = columns[k];
    MatrixVectorMult_DDRM.mult(p, h, g);
    double projected = VectorVectorMult_DDRM.innerProd(h, g);
    double perS = 1 / (projected + 1);
    CommonOps_DDRM.addEquals(x, innovations[k] * perS, g);
    VectorVectorMult_DDRM.addOuterProd(-perS, g, g, p);
    MatrixVectorMult_DDRM.mult(p, h, e);
    CommonOps_DDRM.addEquals(e, -perS, g);
    CommonOps_DDRM.scale(1 / projected, g);
    CommonOps_DDRM.addEquals(e, -0.5 * VectorVectorMult_DDRM.innerProd(h, e), g);
    VectorVectorMult_DDRM.addOuterProd(-1, e, g, p);
    VectorVectorMult_DDRM.addOuterProd(-1, g, e, p);
    symmetrise();
    return x.get(0);
  }

  private void symmetrise() {
    CommonOps_DDRM.transpose(p, work);
    CommonOps_DDRM.add(p, work, p);
    CommonOps_DDRM.scale(0.5, p);
  }

  /**
   * The same by EJML's unrolled operations, for four states (whatever the parameter).
   *
   * @return the state
   */
  @Benchmark
  public double correctionByEjmlFixedSize() {
    int k = next();
    fixedP.a11 += 0.1;
    DMatrix4 h = fixedRows[k];
    CommonOps_DDF4.mult(fixedP, h, fixedG);
    double projected = CommonOps_DDF4.dot(h, fixedG);
    double perS = 1 / (projected + 1);
    CommonOps_DDF4.scale(innovations[k] * perS, fixedG, fixedE);
    CommonOps_DDF4.addEquals(fixedX, fixedE);
    CommonOps_DDF4.multAddOuter(1, fixedP, -perS, fixedG, fixedG, fixedWork);
    CommonOps_DDF4.mult(fixedWork, h, fixedE);
    fixedE.a1 -= perS * fixedG.a1;
    fixedE.a2 -= perS * fixedG.a2;
    fixedE.a3 -= perS * fixedG.a3;
    fixedE.a4 -= perS * fixedG.a4;
    CommonOps_DDF4.scale(1 / projected, fixedG);
    double half = -0.5 * CommonOps_DDF4.dot(h, fixedE);
    fixedE.a1 += half * fixedG.a1;
    fixedE.a2 += half * fixedG.a2;
    fixedE.a3 += half * fixedG.a3;
    fixedE.a4 += half * fixedG.a4;
    CommonOps_DDF4.multAddOuter(1, fixedWork, -1, fixedE, fixedG, fixedP);
    CommonOps_DDF4.multAddOuter(1, fixedP, -1, fixedG, fixedE, fixedWork);
    fixedP.setTo(fixedWork);
    return fixedX.a1;
  }

  /**
   * A prediction by the kernel.
   *
   * @return a variance
   */
  @Benchmark
  public double predictionByKernel() {
    kernel.shear(2, 3, DT_S);
    kernel.addNoise(3, 1e-3);
    return kernel.covariance(2, 2);
  }

  /**
   * The same by EJML's products.
   *
   * @return a variance
   */
  @Benchmark
  public double predictionByEjml() {
    CommonOps_DDRM.mult(transition, p, work);
    CommonOps_DDRM.multTransB(work, transition, p);
    CommonOps_DDRM.addEquals(p, noise);
    return p.get(2, 2);
  }

  /**
   * A filter over models, of a point in a plane: prediction and a vector of two, four states
   * (whatever the parameter).
   *
   * @return what became of it
   */
  @Benchmark
  public UpdateOutcome filterOverModels() {
    plane.predict(DT_S);
    pair.set(0, 0, innovations[next()]);
    pair.set(1, 0, innovations[next]);
    return plane.update(position, pair);
  }
}
