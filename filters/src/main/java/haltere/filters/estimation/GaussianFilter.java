package haltere.filters.estimation;

import java.util.Objects;
import java.util.function.Consumer;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * A state with a covariance, predicted and corrected: what the linear and the extended Kalman
 * filter have in common. Nothing is allocated by a prediction or an update as long as nobody
 * observes it.
 *
 * @param <M> measurements that it takes
 */
public abstract sealed class GaussianFilter<M extends MeasurementModel> implements Estimator<M>
    permits KalmanFilter, ExtendedKalmanFilter {
  private final ProcessModel process;
  private final GapPolicy gap;
  private final InnovationMonitor monitor;
  private final CovarianceStore covariance;
  private final DMatrixRMaj x;
  private final DMatrixRMaj evolved;
  private final DMatrixRMaj stateChange;
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

  GaussianFilter(ProcessModel process, DMatrixRMaj x, DMatrixRMaj p, FilterOptions options) {
    this.process = Objects.requireNonNull(process, "process model");
    int n = process.stateSize();
    gap = options.gap();
    monitor = new InnovationMonitor(options.lossAfter());
    covariance = CovarianceStore.of(options.form(), n);
    this.x = new DMatrixRMaj(n, 1);
    evolved = new DMatrixRMaj(n, 1);
    stateChange = new DMatrixRMaj(n, 1);
    f = new DMatrixRMaj(n, n);
    q = new DMatrixRMaj(n, n);
    launchState = new DMatrixRMaj(n, 1);
    launchCovariance = new DMatrixRMaj(n, n);
    begin(x, p);
  }

  /** x after a step whose F was computed: f(x, Δt), or F x. */
  abstract void evolve(
      ProcessModel model, DMatrixRMaj state, double dtS, DMatrixRMaj transition, DMatrixRMaj out);

  @Override
  public final int stateSize() {
    return process.stateSize();
  }

  @Override
  public final void launch(DMatrixRMaj state, DMatrixRMaj p) {
    begin(state, p);
  }

  @Override
  public final void predict(double dtS) {
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
  public final UpdateOutcome update(M model, DMatrixRMaj z) {
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
  public final int updateOneByOne(M model, DMatrixRMaj z) {
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
      if (!rowInnovation.computeRow(innovation, i, y, covariance.matrix())) {
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
  public final double state(int index) {
    return x.get(index);
  }

  @Override
  public final double covariance(int row, int column) {
    return covariance.matrix().get(row, column);
  }

  @Override
  public final Estimate estimate() {
    return new Estimate(timeS, ConstMatrix.copyOf(x), ConstMatrix.copyOf(covariance.matrix()));
  }

  @Override
  public final InnovationMonitor monitor() {
    return monitor;
  }

  @Override
  public final long relaunches() {
    return relaunches;
  }

  /**
   * Hands every further step to an observer, which may keep it; this allocates.
   *
   * @param newObserver such as {@code steps::add}; null for none
   */
  public final void observe(Consumer<? super FilterStep> newObserver) {
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
  public final double nis() {
    return innovation.nis();
  }

  /**
   * Logarithm of the likelihood of the last update's measurement, given all before it.
   *
   * @return ln N(y; 0, S)
   */
  public final double logLikelihood() {
    return innovation.logLikelihood();
  }

  // ---- In parts, for the mixing of several filters

  final DMatrixRMaj stateView() {
    return x;
  }

  final DMatrixRMaj covarianceView() {
    return covariance.matrix();
  }

  /** Sets state and covariance without making them those to launch from. */
  final void set(DMatrixRMaj state, DMatrixRMaj p) {
    x.setTo(state);
    covariance.set(p);
    if (observer != null) {
      observer.accept(new Launch(estimate()));
    }
  }

  /** Computes the innovation of a measurement; false if it cannot be used. */
  final boolean innovate(M model, DMatrixRMaj z) {
    return innovation.compute(model, z, x, covariance.matrix());
  }

  /** Takes in the measurement of the last innovation. */
  final UpdateOutcome correct() {
    return apply(innovation);
  }

  /** Gates the measurement of the last innovation. */
  final UpdateOutcome refuse() {
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
    process.jacobian(x, dtS, f);
    process.noise(x, dtS, q);
    evolve(process, x, dtS, f, evolved);
    x.setTo(evolved);
    covariance.predict(f, q);
    if (observer != null) {
      observer.accept(
          new Prediction(dtS, ConstMatrix.copyOf(f), ConstMatrix.copyOf(q), estimate()));
    }
  }

  private UpdateOutcome apply(Innovation in) {
    Estimate prior = observer == null ? null : estimate();
    covariance.correct(in, stateChange);
    if (MatrixFeatures_DDRM.hasUncountable(stateChange)) {
      throw new ArithmeticException("the state left the numbers: " + stateChange);
    }
    CommonOps_DDRM.addEquals(x, stateChange);
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
