/** Cameras: their list, settings and counts. */
package haltere.ui.viewer.cameras;
