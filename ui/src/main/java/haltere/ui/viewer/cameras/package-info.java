/** Cameras: which there are, how they are set, what came of them. */
package haltere.ui.viewer.cameras;
