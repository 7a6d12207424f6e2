package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The Kalman filter of a linear process and linear measurements: the best estimate there is, when
 * the model holds.
 *
 * <pre>
 * predict   x⁻ = F x            P⁻ = F P Fᵀ + Q
 * update    y = z − H x⁻        S = H P⁻ Hᵀ + R        K = P⁻ Hᵀ S⁻¹
 *           x = x⁻ + K y        P = (I − K H) P⁻ (I − K H)ᵀ + K R Kᵀ
 * </pre>
 *
 * <p>Kalman (1960), "A new approach to linear filtering and prediction problems"; Bar-Shalom, Li
 * and Kirubarajan (2001), eq. 5.2.3-1 to 5.2.3-18.
 */
public final class KalmanFilter extends GaussianFilter<LinearMeasurement> {
  /**
   * A filter with {@link FilterOptions#DEFAULT}.
   *
   * @param process how the state evolves
   * @param x state to launch from
   * @param p its covariance, positive definite
   */
  public KalmanFilter(LinearProcessModel process, DMatrixRMaj x, DMatrixRMaj p) {
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
  public KalmanFilter(
      LinearProcessModel process, DMatrixRMaj x, DMatrixRMaj p, FilterOptions options) {
    super(process, x, p, options);
  }

  @Override
  void evolve(
      ProcessModel model, DMatrixRMaj state, double dtS, DMatrixRMaj transition, DMatrixRMaj out) {
    CommonOps_DDRM.mult(transition, state, out);
  }
}
