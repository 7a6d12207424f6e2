/**
 * Motions whose equations are known, ready to be estimated: chains of integrators on several axes,
 * a damped oscillator, and a way to integrate others. Times are seconds; noise is a spectral
 * density, so that a model says the same whatever its time steps.
 *
 * @since 0.1
 */
package haltere.filters.estimation.motion;
