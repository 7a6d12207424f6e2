/** Planes in metres: a road by its vanishing point, another one by four points. */
package haltere.ui.viewer.road;
