package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.mult.MatrixVectorMult_DDRM;

/** A process whose state after a step is a matrix, which depends on the step alone, times x. */
interface LinearProcessModel extends ProcessModel {
  /**
   * The transition matrix F(Δt).
   *
   * @param dtS seconds, more than 0
   * @param f square
   */
  void transition(double dtS, DMatrixRMaj f);

  /**
   * The covariance Q(Δt) that a time step adds.
   *
   * @param dtS seconds, more than 0
   * @param q square, symmetric, positive semidefinite
   */
  void noise(double dtS, DMatrixRMaj q);

  /** {@inheritDoc} Here F x; allocates, so the filters multiply by their own F instead. */
  @Override
  default void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
    DMatrixRMaj f = CommonOps_DDRM.identity(stateSize());
    transition(dtS, f);
    MatrixVectorMult_DDRM.mult(f, x, evolved);
  }

  @Override
  default void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f) {
    transition(dtS, f);
  }

  @Override
  default void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
    noise(dtS, q);
  }
}
