/**
 * Interfaces of cameras: services that list and open them, an open camera as an event source, and
 * its optional functions as facets.
 */
package haltere.core.camera;
