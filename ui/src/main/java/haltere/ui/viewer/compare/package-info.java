/** Two chains side by side on the same events. */
package haltere.ui.viewer.compare;
