/**
 * Kalman filters on the clusters of {@code haltere.filters.cluster}, after Cardinale (2006). {@code
 * docs/kalman-tracks.md} has the equations.
 *
 * @since 0.1
 */
package haltere.filters.track;
