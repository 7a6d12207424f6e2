/** Views in space: bodies with the cameras that see them, and events over time. */
package haltere.ui.viewer.space;
