/**
 * The tracker of the wings of a tethered fly: searches the fly, then tracks each wing. Start with
 * {@link haltere.filters.wing.tracker.WingTracker}.
 *
 * @since 0.1
 */
package haltere.filters.wing.tracker;
