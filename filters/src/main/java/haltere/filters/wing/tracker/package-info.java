/**
 * The tracker of the wings of a tethered fly: the fly is searched for, then each wing is tracked.
 * To begin with: {@link haltere.filters.wing.tracker.WingTracker}.
 *
 * @since 0.1
 */
package haltere.filters.wing.tracker;
