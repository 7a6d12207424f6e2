/**
 * Drawing of tracked objects with their paths, outlines and velocities, for clusters, Kalman tracks
 * and objects.
 *
 * @since 0.1
 */
package haltere.filters.trail;
