package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/**
 * Process model of a state: one method per equation.
 *
 * <p>Outputs are preallocated with the right size and arbitrary content; a model fills every entry
 * and allocates nothing. A model has no state, unless stated.
 */
public interface ProcessModel {
  /** {@return the dimension of the state, at least 1} */
  int stateSize();

  /**
   * The state after a time step: f(x, Δt).
   *
   * @param x state, not to be changed
   * @param dtS seconds, more than 0
   * @param evolved the state after the step, never the same object as x
   */
  void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved);

  /**
   * The Jacobian of {@link #evolve} by the state: F = ∂f/∂x at x.
   *
   * @param x state before the step, not to be changed
   * @param dtS seconds, more than 0
   * @param f square
   */
  void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f);

  /**
   * The covariance that a time step adds: a spectral density, integrated over the step.
   *
   * @param x state before the step, not to be changed
   * @param dtS seconds, more than 0
   * @param q square, symmetric, positive semidefinite
   */
  void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q);
}
