/**
 * Filters of an undirected axis whose lines several cameras measure: on the unit sphere with
 * several hypotheses, or with a quaternion; initialisation and smoothing. Angles are in radians.
 *
 * <p>Thread rule of all classes here: one thread at a time.
 */
package haltere.filters.orientation.internal.axis;
