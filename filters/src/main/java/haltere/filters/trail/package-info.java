/**
 * What trackers draw: objects with their paths, outlines and velocities, alike for clusters, Kalman
 * tracks and objects.
 */
package haltere.filters.trail;
