/** Filters that select events by position or polarity. */
package haltere.filters.selection;
