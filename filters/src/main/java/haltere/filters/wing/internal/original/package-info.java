/**
 * Differences of the wing tracker of Cardinale (2006): {@link
 * haltere.filters.wing.internal.original.CentroidSearch} finds the fly, {@link
 * haltere.filters.wing.internal.original.UpdateNoise} is the noise of its filters. It is there for
 * comparison; the rest of the wing tracker is independent of it.
 */
package haltere.filters.wing.internal.original;
