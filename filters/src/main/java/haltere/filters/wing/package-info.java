/**
 * The wings of a tethered fly: the settings of their tracker and what it says. The tracker itself
 * is in {@code wing.tracker}, the search for the fly in {@code wing.search}, and what follows the
 * stroke of one wing in {@code wing.stroke}; nothing here knows those.
 */
package haltere.filters.wing;
