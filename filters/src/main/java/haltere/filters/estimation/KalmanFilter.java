package haltere.filters.estimation;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.Consumer;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * The Kalman filter, extended for nonlinear models: state by the model's own equations, covariance
 * by their Jacobians at the estimate.
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
 * section 10.3.3, first order. Mean and covariance are a {@link GaussianState}; predictions and
 * updates allocate nothing without an observer.
 *
 * <p>Time steps are seconds and must be finite and not negative: a caller whose clock jumps back
 * launches again. A step of 0 has no effect. A measurement that is not finite is rejected with
 * {@link UpdateOutcome#UNUSABLE}; the estimate is unchanged.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class KalmanFilter {
  private final ProcessModel process;
  private final GaussianState belief;
  private final DMatrixRMaj evolved;
  private final DMatrixRMaj f;
  private final DMatrixRMaj q;
  private final Innovation innovation = new Innovation();
  private Consumer<? super FilterStep> observer;
  private double timeS;

  /**
   * A filter.
   *
   * @param process the process model
   * @param x state to launch from
   * @param p its covariance, positive definite
   */
  public KalmanFilter(ProcessModel process, DMatrixRMaj x, DMatrixRMaj p) {
    this.process = Objects.requireNonNull(process, "process model");
    int n = process.stateSize();
    belief = new GaussianState(n);
    evolved = new DMatrixRMaj(n, 1);
    f = new DMatrixRMaj(n, n);
    q = new DMatrixRMaj(n, n);
    launch(x, p);
  }

  /**
   * Begins (again) from a state. The clock continues.
   *
   * @param x state, copied
   * @param p its covariance, symmetric and positive definite, copied
   */
  public void launch(DMatrixRMaj x, DMatrixRMaj p) {
    Require.state(x, process.stateSize());
    Require.covariance("covariance", p, process.stateSize());
    belief.set(x, p);
    if (observer != null) {
      observer.accept(new FilterStep.Launch(estimate()));
    }
  }

  /**
   * Predicts over a time step.
   *
   * @param dtS seconds, finite and not negative
   */
  public void predict(double dtS) {
    timeS += Require.timeStep(dtS);
    if (dtS == 0) {
      return;
    }
    DMatrixRMaj x = belief.mean();
    process.jacobian(x, dtS, f);
    process.noise(x, dtS, q);
    process.evolve(x, dtS, evolved);
    x.setTo(evolved);
    belief.predict(f, q);
    if (observer != null) {
      observer.accept(
          new FilterStep.Prediction(dtS, ConstMatrix.copyOf(f), ConstMatrix.copyOf(q), estimate()));
    }
  }

  /**
   * Updates with a measurement inside its gate.
   *
   * @param model of the measurement
   * @param z the measurement, not kept
   * @return the outcome
   * @throws ArithmeticException if the state is not finite, as after divergence of an extended
   *     filter; launch again
   */
  public UpdateOutcome update(MeasurementModel model, DMatrixRMaj z) {
    if (!innovation.compute(model, z, belief.mean(), belief.covariance())) {
      return UpdateOutcome.UNUSABLE;
    }
    Estimate prior = observer == null ? null : estimate();
    if (!model.gate().passes(innovation.nis, innovation.size())) {
      return note(UpdateOutcome.GATED, prior);
    }
    belief.correct(innovation);
    if (MatrixFeatures_DDRM.hasUncountable(belief.mean())) {
      throw new ArithmeticException("the state is no longer finite: " + belief.mean());
    }
    return note(UpdateOutcome.APPLIED, prior);
  }

  /**
   * Updates with a measurement given as numbers; allocates.
   *
   * @param model of the measurement
   * @param z the measurement
   * @return the outcome
   */
  public UpdateOutcome update(MeasurementModel model, double... z) {
    return update(model, new DMatrixRMaj(z.length, 1, true, Arrays.copyOf(z, z.length)));
  }

  /**
   * One entry of the state.
   *
   * @param index from 0
   * @return in the entry's unit
   */
  public double state(int index) {
    return belief.mean(index);
  }

  /**
   * One entry of the covariance.
   *
   * @param row from 0
   * @param column from 0
   * @return in the product of the two entries' units
   */
  public double covariance(int row, int column) {
    return belief.covariance(row, column);
  }

  /** {@return the present estimate, an immutable copy} */
  public Estimate estimate() {
    return new Estimate(
        timeS, ConstMatrix.copyOf(belief.mean()), ConstMatrix.copyOf(belief.covariance()));
  }

  /**
   * Passes every further step to an observer, which may store it; this allocates.
   *
   * @param newObserver such as {@code steps::add}; null for none
   */
  public void observe(Consumer<? super FilterStep> newObserver) {
    observer = newObserver;
    if (observer != null) {
      observer.accept(new FilterStep.Launch(estimate()));
    }
  }

  private UpdateOutcome note(UpdateOutcome outcome, Estimate prior) {
    if (observer != null) {
      observer.accept(
          new FilterStep.Correction(
              outcome,
              prior,
              ConstMatrix.copyOf(innovation.y),
              ConstMatrix.copyOf(innovation.s),
              ConstMatrix.copyOf(innovation.gain),
              innovation.nis,
              estimate()));
    }
    return outcome;
  }
}
