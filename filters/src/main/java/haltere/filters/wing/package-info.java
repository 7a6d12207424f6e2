/**
 * The wings of a tethered fly: the fly is found in the events of a few beats, then each wing is
 * tracked within its beat by an extended Kalman filter or a running average. To begin with: {@link
 * haltere.filters.wing.WingTracker}; the equations are in {@code StrokeEkf} and {@code
 * WingEstimator}.
 */
package haltere.filters.wing;
