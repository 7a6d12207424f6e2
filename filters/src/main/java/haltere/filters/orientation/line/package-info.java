/**
 * The line that a camera sees of a body: a filter that follows a body through events and reports
 * its position and direction in the picture, in pixels and radians. No calibration is needed.
 *
 * @since 0.1
 */
package haltere.filters.orientation.line;
