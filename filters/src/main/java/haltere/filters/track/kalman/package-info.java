/**
 * Estimates tracks of things that move: which measurement belongs to which track, how each goes on,
 * and, on a road, vehicles, their speed and the lines they cross. How the state of one is estimated
 * is in {@link haltere.filters.track.motion}, and how what moves on a road is found in {@link
 * haltere.filters.track.road}. To begin with: {@link
 * haltere.filters.track.kalman.KalmanTracksFilter}.
 */
package haltere.filters.track.kalman;
