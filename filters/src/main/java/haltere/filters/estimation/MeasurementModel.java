package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Measurement model z = h(x) + v, v of covariance R; one method per equation.
 *
 * <p>Outputs are preallocated with the right size and arbitrary content; a model fills every entry
 * and allocates nothing.
 */
public interface MeasurementModel {
  /** {@return the dimension of the measurement, at least 1} */
  int size();

  /**
   * The expected measurement of a state: h(x).
   *
   * @param x state, not to be changed
   * @param z expected measurement
   */
  void expected(DMatrixRMaj x, DMatrixRMaj z);

  /**
   * The Jacobian of {@link #expected} by the state: H = ∂h/∂x at x.
   *
   * @param x state, not to be changed
   * @param h a row per measured number, a column per state
   */
  void jacobian(DMatrixRMaj x, DMatrixRMaj h);

  /**
   * The covariance of the measurement's own noise.
   *
   * @param x state, not to be changed; unused by most models
   * @param r square, symmetric, positive definite
   */
  void noise(DMatrixRMaj x, DMatrixRMaj r);

  /**
   * The innovation y = z − h(x). A model of angles overrides this and wraps: {@link Angles#wrapPi}.
   *
   * @param z measurement
   * @param expected h(x)
   * @param y innovation
   */
  default void residual(DMatrixRMaj z, DMatrixRMaj expected, DMatrixRMaj y) {
    CommonOps_DDRM.subtract(z, expected, y);
  }

  /** {@return the gate for innovations, open unless overridden} */
  default Gate gate() {
    return Gate.OPEN;
  }
}
