/**
 * Follows the stroke of one wing within its beat: an extended Kalman filter over both edges, one
 * for each edge, or a running average. The equations are in {@code StrokeEkf} and {@link
 * haltere.filters.wing.internal.stroke.WingEstimator}.
 */
package haltere.filters.wing.internal.stroke;
