/** Cameras as the rest of Haltere sees them: services that list and open them. */
package haltere.core.camera;
