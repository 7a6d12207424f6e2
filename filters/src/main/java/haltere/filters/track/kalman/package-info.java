/**
 * Estimates tracks of things that move: which measurement belongs to which track, how each goes on,
 * and, on a road, vehicles, their speed and the lines they cross. To begin with: {@link
 * haltere.filters.track.kalman.TrackEstimator}.
 */
package haltere.filters.track.kalman;
