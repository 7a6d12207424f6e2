/**
 * Classic clusters: rectangles or ellipses of Cardinale (2006) that events move, with the options
 * of the trackers that followed. {@code docs/clusters.md} has the equations.
 *
 * @since 0.1
 */
package haltere.filters.cluster;
