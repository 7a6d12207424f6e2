/**
 * Estimators that state how sure they are: linear and extended Kalman filters, interacting multiple
 * models, a smoother, and the tools that tell whether their covariances are honest.
 *
 * <ul>
 *   <li>A model is one method per equation: {@link haltere.filters.estimation.ProcessModel}
 *       (evolution, Jacobian, noise for a time step) and {@link
 *       haltere.filters.estimation.MeasurementModel} (expectation, Jacobian, noise, residual,
 *       gate). Motions that are often needed stand in {@code motion}.
 *   <li>{@link haltere.filters.estimation.KalmanFilter} and {@link
 *       haltere.filters.estimation.ExtendedKalmanFilter} are the clear form, on matrices; {@link
 *       haltere.filters.estimation.InteractingMultipleModels} mixes several.
 *   <li>{@link haltere.filters.estimation.ConstantVelocityAxis}, {@link
 *       haltere.filters.estimation.ConstantVelocityPlane} and {@link
 *       haltere.filters.estimation.FourStateEkf} are the fast form, written out on primitive fields
 *       for use at every event; tests hold them against the clear form.
 *   <li>{@link haltere.filters.estimation.Consistency} (NEES, NIS, whiteness) and {@link
 *       haltere.filters.estimation.ChiSquare} judge an estimator.
 * </ul>
 *
 * <p>Nothing here knows of events or of the chain; times are seconds, angles radians, and noise is
 * a spectral density, so that tuning does not depend on the event rate. Symbols are those of the
 * literature: x state, P its covariance, F transition, Q process noise, z measurement, H its
 * Jacobian, R its noise, y innovation, S its covariance, K gain.
 */
package haltere.filters.estimation;
