/**
 * Estimates the stroke of one wing within its beat: an extended Kalman filter over both edges, one
 * for each edge, or a running average. The equations are in {@code StrokeEkf} and {@link
 * haltere.filters.wing.internal.stroke.WingEstimator}.
 *
 * <p>Thread rule of all classes here: one thread at a time.
 */
package haltere.filters.wing.internal.stroke;
