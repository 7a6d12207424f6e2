/**
 * Estimators with covariances: linear and extended Kalman filters, a smoother and a batch
 * estimator.
 *
 * <ul>
 *   <li>A model is one method per equation: {@link haltere.filters.estimation.ProcessModel}
 *       (evolution, Jacobian, noise for a time step) and {@link
 *       haltere.filters.estimation.MeasurementModel} (expectation, Jacobian, noise, residual,
 *       gate). Common motions are in {@code motion}.
 *   <li>{@link haltere.filters.estimation.GaussianState} is the kernel: mean and covariance with
 *       the operations on them, allocation-free, for use at every event. Every estimator keeps its
 *       covariance there.
 *   <li>{@link haltere.filters.estimation.KalmanFilter} runs it over models; {@link
 *       haltere.filters.estimation.RtsSmoother} smooths recorded steps.
 * </ul>
 *
 * <p>The package is independent of events and the chain; times are seconds, angles radians, and
 * noise is a spectral density, so that tuning does not depend on the event rate. Symbols are those
 * of the literature: x state, P its covariance, F transition, Q process noise, z measurement, H its
 * Jacobian, R its noise, y innovation, S its covariance, K gain.
 *
 * @since 0.1
 */
package haltere.filters.estimation;
