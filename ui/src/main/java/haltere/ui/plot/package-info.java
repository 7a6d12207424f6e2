/**
 * Published results over time, ready to be drawn: what can be plotted, the way of the numbers from
 * the processing thread to the window, and curves of bounded memory. Knows no toolkit. Thread rule:
 * a type that names none of its own is for one thread at a time.
 */
package haltere.ui.plot;
