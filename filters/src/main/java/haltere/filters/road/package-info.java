/**
 * Lanes of a road, and lines at which tracks on it are counted.
 *
 * @since 0.1
 */
package haltere.filters.road;
