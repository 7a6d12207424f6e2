/** Filters that select events by where they are or by their polarity. */
package haltere.filters.selection;
