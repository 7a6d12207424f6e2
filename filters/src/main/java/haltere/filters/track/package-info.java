/**
 * Tracks of things that move: the settings of their estimator and what it says of them, and where
 * on the road an image position lies. The estimator itself is in {@code track.kalman}; nothing here
 * knows it.
 */
package haltere.filters.track;
