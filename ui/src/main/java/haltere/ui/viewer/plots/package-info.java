/**
 * Plots of what filters publish over time. What is plotted, and how it gets here from the
 * processing thread, is {@code haltere.ui.plot}; here it is drawn.
 */
package haltere.ui.viewer.plots;
