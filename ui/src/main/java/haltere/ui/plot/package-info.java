/**
 * Published results over time: the fields, the transfer from the processing thread to the window,
 * and curves of bounded memory. Independent of a toolkit. Thread rule, unless a type states
 * another: one thread at a time.
 */
package haltere.ui.plot;
