/**
 * Cameras that see a body in space, and what they saw: the model of a camera and its lens, and the
 * files in which calibrations and observations are exchanged. World units are metres, image units
 * pixels, angles radians.
 *
 * @since 0.1
 */
package haltere.filters.orientation.camera;
