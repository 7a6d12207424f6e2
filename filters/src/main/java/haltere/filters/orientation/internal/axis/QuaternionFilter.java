package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.GaussianState;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The form of Straw et al. (2011): body rates and a unit quaternion ({@link BodyQuaternion}),
 * predicted by {@link QuaternionMotion}. After each step and update the quaternion is normalised
 * and P projected. The rotation about the axis is a state here although it is not observable, so
 * that its variance grows. For comparison; steps allocate.
 */
public final class QuaternionFilter implements AxisFilter {
  private static final int N = 7;

  /** Consecutive times with most lines rejected after which an axis is lost. */
  private static final int LOST_AFTER = 3;

  /** Times with all lines accepted after which an axis is established. */
  private static final int ESTABLISHED = 3;

  private final double rateVariance;
  private final double updateNoise;
  private final double gateRad;
  private final double outlierShare;
  private final GaussianState state = new GaussianState(N);
  private final double[] x = state.mean().data;
  private final double[] prior = new double[N];
  private final double[] u = new double[3];
  private final double[] gradient = new double[3];
  private final DMatrixRMaj projection = CommonOps_DDRM.identity(N);
  private final QuaternionMotion motion;

  /** Consecutive times with most lines rejected, and with all lines used. */
  private int rejectedTimes;

  private int agreements;

  /**
   * A filter without an axis.
   *
   * @param model of the axis and its lines
   */
  public QuaternionFilter(AxisModel model) {
    rateVariance = model.meanRateVariance();
    updateNoise = model.updateNoise();
    motion = new QuaternionMotion(model.decayS(), rateVariance, updateNoise);
    gateRad = model.gateRad();
    outlierShare = model.outlierShare();
  }

  @Override
  public void launch(AxisLaunch found) {
    launch(found.axis(), found.covariance());
    rejectedTimes = 0;
    agreements = found.lines() > 2 ? ESTABLISHED : 0;
  }

  /** Starts with an axis and its covariance in the world. */
  void launch(double[] axis, double[] covariance) {
    state.mean().zero();
    BodyQuaternion.set(x, axis);
    if (updateNoise > 0) {
      state.setVariances(0.5, 0.5, 0.5, 1, 1, 1, 1);
      return;
    }
    state.setVariances(rateVariance, rateVariance, rateVariance, 0, 0, 0, 0);
    // half Ξ Aᵀ/2 maps an error of the axis to the quaternion; roll is Ξ's first column
    DMatrixRMaj byRates = BodyQuaternion.byRates(x);
    DMatrixRMaj byAxis = CommonOps_DDRM.transpose(BodyQuaternion.axisByQuaternion(x), null);
    CommonOps_DDRM.scale(0.25, byAxis);
    DMatrixRMaj moved = new DMatrixRMaj(4, 3);
    DMatrixRMaj block = new DMatrixRMaj(4, 4);
    CommonOps_DDRM.mult(byAxis, DMatrixRMaj.wrap(3, 3, covariance), moved);
    CommonOps_DDRM.multTransB(moved, byAxis, block);
    DMatrixRMaj roll = CommonOps_DDRM.extractColumn(byRates, 0, null);
    CommonOps_DDRM.multAddTransB(0.25 * Math.PI * Math.PI / 3, roll, roll, block);
    CommonOps_DDRM.insert(block, state.covariance(), 3, 3);
  }

  @Override
  public void predict(double dtS) {
    if (dtS > 0) {
      motion.step(x, dtS);
      state.predict(motion.transition, motion.noise);
      normalise();
    }
  }

  /** Normalises the quaternion and projects P. */
  private void normalise() {
    double n = Math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    for (int i = 3; i < N; i++) {
      x[i] /= n;
    }
    for (int i = 3; i < N; i++) {
      for (int j = 3; j < N; j++) {
        projection.set(i, j, ((i == j ? 1 : 0) - x[i] * x[j]) / n);
      }
    }
    state.transform(projection);
  }

  @Override
  public void update(LineMeasurement[] lines, int count) {
    BodyQuaternion.axis(x, u);
    System.arraycopy(x, 0, prior, 0, N);
    for (int i = 0; i < count; i++) {
      LineMeasurement line = lines[i];
      line.residualRad = line.residual(u);
      line.used = false;
      line.nis = Double.NaN;
      if (Math.abs(line.residualRad) < gateRad && line.gradient(u, gradient)) {
        correct(line);
      }
    }
    normalise();
    BodyQuaternion.axis(x, u);
    for (int i = 0; i < count; i++) {
      // a step of expectation and maximisation: R is the mean of ε² + H P⁺ Hᵀ
      double y = lines[i].residual(u);
      boolean isSeen = lines[i].gradient(u, gradient);
      lines[i].ownRad2 = isSeen ? y * y + state.project(row(x)) : Double.NaN;
    }
  }

  /**
   * All lines are linearised at the prediction, so that their order is irrelevant: one stacked
   * update.
   */
  private void correct(LineMeasurement line) {
    double[] h = row(prior);
    double y = line.residualRad;
    for (int i = 3; i < N; i++) {
      y -= h[i] * (x[i] - prior[i]);
    }
    double s = state.project(h) + line.varianceRad2;
    double nis = y * y / s;
    double any = outlierShare / Math.PI * Math.sqrt(2 * Math.PI * s);
    boolean isOutlier = outlierShare > 0 && (1 - outlierShare) * Math.exp(-0.5 * nis) < any;
    if (!isOutlier && state.correct(y, line.varianceRad2)) {
      line.used = true;
      line.nis = nis;
    }
  }

  /** ∂θ/∂x = ∂θ/∂u ∂u/∂x, by the last gradient. */
  private double[] row(double[] at) {
    DMatrixRMaj byAxis = new DMatrixRMaj(1, 3, true, gradient);
    DMatrixRMaj row = new DMatrixRMaj(1, 4);
    CommonOps_DDRM.mult(byAxis, BodyQuaternion.axisByQuaternion(at), row);
    return inState(row.data);
  }

  private static double[] inState(double[] quaternion) {
    double[] row = new double[N];
    System.arraycopy(quaternion, 0, row, 3, 4);
    return row;
  }

  /**
   * A new axis, whose initial lines may be outliers, is searched again as soon as most lines are
   * rejected; an established one after several times in a row.
   */
  @Override
  public boolean needsSearch(LineMeasurement[] lines, int count) {
    int used = 0;
    for (int i = 0; i < count; i++) {
      used += lines[i].used ? 1 : 0;
    }
    boolean isMajority = count <= 2 ? used < count : 2 * used <= count;
    rejectedTimes = count == 0 || !isMajority ? 0 : rejectedTimes + 1;
    agreements += count > 1 && used == count ? 1 : 0;
    return rejectedTimes > 0 && (agreements < ESTABLISHED || rejectedTimes >= LOST_AFTER);
  }

  @Override
  public boolean offer(AxisLaunch found) {
    launch(found);
    return true;
  }

  @Override
  public Axis axis() {
    double[] tip = new double[3];
    BodyQuaternion.axis(x, u);
    BodyQuaternion.tipVelocity(x, tip);
    DMatrixRMaj byQuaternion = BodyQuaternion.axisByQuaternion(x);
    double variance = 0;
    for (int i = 0; i < 3; i++) {
      variance += state.project(inState(CommonOps_DDRM.extractRow(byQuaternion, i, null).data));
    }
    return new Axis(u.clone(), tip, variance, 1, rejectedTimes == 0, rollSd(), x[0]);
  }

  /**
   * The variance of roll can only grow. P is linearised at a changing rate, so that updates of the
   * axis reduce it falsely; hence the lower bound.
   */
  private double rollSd() {
    DMatrixRMaj roll = CommonOps_DDRM.extractColumn(BodyQuaternion.byRates(x), 0, null);
    double variance = 4 * state.project(inState(roll.data));
    return Math.max(Math.PI / Math.sqrt(3), Math.sqrt(Math.max(0, variance)));
  }

  @Override
  public boolean isValid() {
    return Double.isFinite(CommonOps_DDRM.elementSum(state.covariance()) + x[0] + x[1] + x[2])
        && x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6] > 0.5;
  }
}
