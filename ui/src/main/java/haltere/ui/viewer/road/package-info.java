/** The vanishing point of a road, which gives the distances of tracked vehicles. */
package haltere.ui.viewer.road;
