/**
 * Cameras as the rest of Haltere sees them: services that list and open them, an opened camera as a
 * source of events, and its abilities as facets.
 */
package haltere.core.camera;
