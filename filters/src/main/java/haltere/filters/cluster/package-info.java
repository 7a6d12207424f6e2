/** Follows compact groups of events: things that move. */
package haltere.filters.cluster;
