/**
 * Maps from pixels to a plane in the scene and back: a road seen from a bridge, an arena, a belt.
 * Trackers with positions in metres use it.
 *
 * @since 0.1
 */
package haltere.filters.plane;
