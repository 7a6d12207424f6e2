package haltere.filters.estimation;

import java.util.Objects;
import java.util.function.Consumer;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * The Kalman filter, extended where a model is not linear: state by the model's own equations,
 * covariance by their Jacobians at the estimate.
 *
 * <pre>
 * predict   x⁻ = f(x, Δt)       P⁻ = F P Fᵀ + Q        F = ∂f/∂x at x
 * update    y = z ⊖ h(x⁻)       S = H P⁻ Hᵀ + R        H = ∂h/∂x at x⁻
 *           K = P⁻ Hᵀ S⁻¹       x = x⁻ + K y
 *           P = (I − K H) P⁻ (I − K H)ᵀ + K R Kᵀ
 * </pre>
 *
 * <p>⊖ is the model's residual, which wraps angles. S is factored by Cholesky or, for a single
 * number, divided by; nothing is ever inverted. Kalman (1960), "A new approach to linear filtering
 * and prediction problems"; Bar-Shalom, Li and Kirubarajan (2001), eq. 5.2.3-1 to 5.2.3-18 and
 * section 10.3.3, first order. Mean and covariance are a {@link GaussianState}; nothing is
 * allocated by a prediction or an update as long as nobody observes it.
 */
public final class KalmanFilter implements Estimator {
  private final ProcessModel process;
  private final GapPolicy gap;
  private final InnovationMonitor monitor;
  private final GaussianState belief;
  private final DMatrixRMaj evolved;
  private final DMatrixRMaj f;
  private final DMatrixRMaj q;
  private final DMatrixRMaj launchState;
  private final DMatrixRMaj launchCovariance;
  private final Innovation innovation = new Innovation();
  private final Innovation rowInnovation = new Innovation();
  private Consumer<? super FilterStep> observer;
  private double timeS;
  private double gapS;
  private long relaunches;

  /**
   * A filter with {@link FilterOptions#DEFAULT}.
   *
   * @param process how the state evolves
   * @param x state to launch from
   * @param p its covariance, positive definite
   */
  public KalmanFilter(ProcessModel process, DMatrixRMaj x, DMatrixRMaj p) {
    this(process, x, p, FilterOptions.DEFAULT);
  }

  /**
   * A filter.
   *
   * @param process how the state evolves
   * @param x state to launch from
   * @param p its covariance, positive definite
   * @param options gap policy, loss of lock
   */
  public KalmanFilter(ProcessModel process, DMatrixRMaj x, DMatrixRMaj p, FilterOptions options) {
    this.process = Objects.requireNonNull(process, "process model");
    int n = process.stateSize();
    gap = options.gap();
    monitor = new InnovationMonitor(options.lossAfter());
    belief = new GaussianState(n);
    evolved = new DMatrixRMaj(n, 1);
    f = new DMatrixRMaj(n, n);
    q = new DMatrixRMaj(n, n);
    launchState = new DMatrixRMaj(n, 1);
    launchCovariance = new DMatrixRMaj(n, n);
    begin(x, p);
  }

  @Override
  public int stateSize() {
    return process.stateSize();
  }

  @Override
  public void launch(DMatrixRMaj state, DMatrixRMaj p) {
    begin(state, p);
  }

  @Override
  public void predict(double dtS) {
    Require.timeStep(dtS);
    timeS += dtS;
    if (gap.relaunches(gapS, dtS)) {
      relaunches++;
      gapS = 0;
      set(launchState, launchCovariance);
      monitor.endRun();
      return;
    }
    double stepS = gap.predicted(gapS, dtS);
    gapS += dtS;
    if (stepS > 0) {
      step(stepS);
    }
  }

  @Override
  public UpdateOutcome update(MeasurementModel model, DMatrixRMaj z) {
    boolean usable = innovate(model, z);
    if (!usable) {
      return monitor.noteUnusable();
    }
    if (!model.gate().passes(innovation.nis(), innovation.size())) {
      return refuse();
    }
    return correct();
  }

  /**
   * Takes in a vector of independent measurements one number after the other: no matrix is
   * factored, and each number has a gate of its own. Without gating the result is that of {@link
   * #update} to rounding: the model is linearised once, at the prediction.
   *
   * @param model its noise R must be diagonal
   * @param z the measurement, not kept
   * @return how many numbers were taken in
   */
  public int updateOneByOne(MeasurementModel model, DMatrixRMaj z) {
    DMatrixRMaj x = belief.mean();
    innovation.computeModel(model, z, x);
    requireIndependent(innovation.r);
    DMatrixRMaj before = evolved;
    before.setTo(x);
    int applied = 0;
    for (int i = 0; i < innovation.size(); i++) {
      double y = innovation.y.get(i);
      for (int j = 0; j < x.numRows; j++) {
        y -= innovation.h.get(i, j) * (x.get(j) - before.get(j));
      }
      if (!rowInnovation.computeRow(innovation, i, y, belief.covariance())) {
        monitor.noteUnusable();
      } else if (!model.gate().passes(rowInnovation.nis(), 1)) {
        note(monitor.noteGated(), rowInnovation, null);
      } else if (apply(rowInnovation).applied()) {
        applied++;
      }
    }
    return applied;
  }

  @Override
  public double state(int index) {
    return belief.mean(index);
  }

  @Override
  public double covariance(int row, int column) {
    return belief.covariance(row, column);
  }

  @Override
  public Estimate estimate() {
    return new Estimate(
        timeS, ConstMatrix.copyOf(belief.mean()), ConstMatrix.copyOf(belief.covariance()));
  }

  @Override
  public InnovationMonitor monitor() {
    return monitor;
  }

  @Override
  public long relaunches() {
    return relaunches;
  }

  /**
   * Hands every further step to an observer, which may keep it; this allocates.
   *
   * @param newObserver such as {@code steps::add}; null for none
   */
  public void observe(Consumer<? super FilterStep> newObserver) {
    observer = newObserver;
    if (observer != null) {
      observer.accept(new Launch(estimate()));
    }
  }

  /**
   * Normalised innovation squared of the last update, whether it was taken in or not.
   *
   * @return yᵀ S⁻¹ y
   */
  public double nis() {
    return innovation.nis();
  }

  /**
   * Logarithm of the likelihood of the last update's measurement, given all before it.
   *
   * @return ln N(y; 0, S)
   */
  public double logLikelihood() {
    return innovation.logLikelihood();
  }

  // ---- In parts, for the mixing of several filters

  GaussianState belief() {
    return belief;
  }

  /** Sets state and covariance without making them those to launch from. */
  void set(DMatrixRMaj state, DMatrixRMaj p) {
    belief.set(state, p);
    if (observer != null) {
      observer.accept(new Launch(estimate()));
    }
  }

  /** Computes the innovation of a measurement; false if it cannot be used. */
  boolean innovate(MeasurementModel model, DMatrixRMaj z) {
    return innovation.compute(model, z, belief.mean(), belief.covariance());
  }

  /** Takes in the measurement of the last innovation. */
  UpdateOutcome correct() {
    return apply(innovation);
  }

  /** Gates the measurement of the last innovation. */
  UpdateOutcome refuse() {
    return note(monitor.noteGated(), innovation, null);
  }

  private void begin(DMatrixRMaj state, DMatrixRMaj p) {
    Require.state(state, process.stateSize());
    Require.covariance("covariance", p, process.stateSize());
    launchState.setTo(state);
    launchCovariance.setTo(p);
    gapS = 0;
    monitor.endRun();
    set(state, p);
  }

  private void step(double dtS) {
    DMatrixRMaj x = belief.mean();
    process.jacobian(x, dtS, f);
    process.noise(x, dtS, q);
    if (process instanceof LinearProcessModel) {
      // f(x, Δt) is F x, and F is there already
      CommonOps_DDRM.mult(f, x, evolved);
    } else {
      process.evolve(x, dtS, evolved);
    }
    x.setTo(evolved);
    belief.predict(f, q);
    if (observer != null) {
      observer.accept(
          new Prediction(dtS, ConstMatrix.copyOf(f), ConstMatrix.copyOf(q), estimate()));
    }
  }

  private UpdateOutcome apply(Innovation in) {
    Estimate prior = observer == null ? null : estimate();
    belief.correct(in);
    if (MatrixFeatures_DDRM.hasUncountable(belief.mean())) {
      throw new ArithmeticException("the state is no longer finite: " + belief.mean());
    }
    gapS = 0;
    return note(monitor.noteApplied(), in, prior);
  }

  private UpdateOutcome note(UpdateOutcome outcome, Innovation in, Estimate prior) {
    if (observer != null) {
      Estimate now = estimate();
      observer.accept(
          new Correction(
              outcome,
              prior == null ? now : prior,
              ConstMatrix.copyOf(in.h),
              ConstMatrix.copyOf(in.y),
              ConstMatrix.copyOf(in.s),
              ConstMatrix.copyOf(in.gain),
              in.nis(),
              in.logLikelihood(),
              now));
    }
    return outcome;
  }

  private static void requireIndependent(DMatrixRMaj r) {
    for (int i = 0; i < r.numRows; i++) {
      for (int j = 0; j < i; j++) {
        if (r.get(i, j) != 0 || r.get(j, i) != 0) {
          throw new IllegalArgumentException("R is not diagonal: its measurements are not apart");
        }
      }
    }
  }
}
