/** Views in space: bodies with cameras, and events over time. */
package haltere.ui.viewer.space;
