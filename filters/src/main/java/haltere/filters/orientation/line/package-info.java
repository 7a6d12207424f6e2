/**
 * Line of a body in a camera: a filter that tracks a body in events and reports its position and
 * direction in the picture, in pixels and radians. No calibration is needed.
 *
 * @since 0.1
 */
package haltere.filters.orientation.line;
