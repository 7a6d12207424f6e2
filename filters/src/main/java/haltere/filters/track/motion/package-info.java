/**
 * How a point in a plane moves: extended Kalman filters of fixed size, one for each way of moving,
 * and what they say together. Nothing here knows of tracks, clusters or lines on a road. To begin
 * with: {@link haltere.filters.track.motion.MotionModes}; the equations are in {@code PlaneFilter}.
 */
package haltere.filters.track.motion;
