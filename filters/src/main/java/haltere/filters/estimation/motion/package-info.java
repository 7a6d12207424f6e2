/**
 * Process models of common motions: chains of integrators on several axes, a damped oscillator, and
 * an integrator for others. Times are seconds; noise is a spectral density, so that a model is
 * independent of its time steps.
 *
 * @since 0.1
 */
package haltere.filters.estimation.motion;
