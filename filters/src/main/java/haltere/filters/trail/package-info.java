/**
 * What trackers draw: objects with their paths, outlines and velocities, alike for clusters, Kalman
 * tracks and objects.
 *
 * @since 0.1
 */
package haltere.filters.trail;
