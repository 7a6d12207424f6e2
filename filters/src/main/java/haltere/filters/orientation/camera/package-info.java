/**
 * Cameras that see a body in space, and what they saw: the model of a camera and its lens, the
 * files in which calibrations and observations are exchanged, and the place in space that several
 * pictures of it tell. World units are metres, image units pixels, angles radians.
 */
package haltere.filters.orientation.camera;
