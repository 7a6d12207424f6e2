/**
 * The wings of a tethered fly: settings and results of their tracker, which is in {@code
 * wing.tracker}.
 *
 * @since 0.1
 */
package haltere.filters.wing;
