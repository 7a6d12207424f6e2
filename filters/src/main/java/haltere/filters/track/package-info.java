/**
 * Kalman filters on the clusters of {@code haltere.filters.cluster}, after Cardinale (2006). {@code
 * docs/tracking.md} has the equations.
 */
package haltere.filters.track;
