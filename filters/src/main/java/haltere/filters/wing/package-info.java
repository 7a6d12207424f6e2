/**
 * The wings of a tethered fly: the settings of their tracker and what it says. The tracker itself
 * is in {@code wing.tracker}; nothing here knows it.
 *
 * @since 0.1
 */
package haltere.filters.wing;
