/**
 * Calibrated cameras and their observations of bodies: the model of a camera and its lens, and
 * files of calibrations and observations. World units are metres, image units pixels, angles
 * radians.
 *
 * @since 0.1
 */
package haltere.filters.orientation.camera;
