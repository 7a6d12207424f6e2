/** Drawing of plots of published results over time; their data is in {@code haltere.ui.plot}. */
package haltere.ui.viewer.plots;
