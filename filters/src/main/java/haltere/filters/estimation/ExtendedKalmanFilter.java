package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The extended Kalman filter: state by the model's own equations, covariance by their Jacobians at
 * the estimate.
 *
 * <pre>
 * predict   x⁻ = f(x, Δt)       P⁻ = F P Fᵀ + Q        F = ∂f/∂x at x
 * update    y = z ⊖ h(x⁻)       S = H P⁻ Hᵀ + R        H = ∂h/∂x at x⁻
 *           K = P⁻ Hᵀ S⁻¹       x = x⁻ + K y
 *           P = (I − K H) P⁻ (I − K H)ᵀ + K R Kᵀ
 * </pre>
 *
 * <p>⊖ is the model's residual, which wraps angles. S is factored by Cholesky or, for a single
 * number, divided by; nothing is ever inverted. Bar-Shalom, Li and Kirubarajan (2001), section
 * 10.3.3, first order. Of linear models it is the linear filter.
 */
public final class ExtendedKalmanFilter extends GaussianFilter<MeasurementModel> {
  /**
   * A filter with {@link FilterOptions#DEFAULT}.
   *
   * @param process how the state evolves
   * @param x state to launch from
   * @param p its covariance, positive definite
   */
  public ExtendedKalmanFilter(ProcessModel process, DMatrixRMaj x, DMatrixRMaj p) {
    this(process, x, p, FilterOptions.DEFAULT);
  }

  /**
   * A filter.
   *
   * @param process how the state evolves
   * @param x state to launch from
   * @param p its covariance, positive definite
   * @param options form, gap policy, loss of lock
   */
  public ExtendedKalmanFilter(
      ProcessModel process, DMatrixRMaj x, DMatrixRMaj p, FilterOptions options) {
    super(process, x, p, options);
  }

  @Override
  void evolve(
      ProcessModel model, DMatrixRMaj state, double dtS, DMatrixRMaj transition, DMatrixRMaj out) {
    if (model instanceof LinearProcessModel) {
      // f(x, Δt) is F x, and F is there already
      CommonOps_DDRM.mult(transition, state, out);
    } else {
      model.evolve(state, dtS, out);
    }
  }
}
