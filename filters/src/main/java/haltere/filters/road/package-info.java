/** Lanes of a road, and lines at which tracks on it are counted. */
package haltere.filters.road;
