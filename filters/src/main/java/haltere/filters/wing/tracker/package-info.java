/**
 * The tracker of the wings of a tethered fly: the fly is searched for, then each wing is tracked.
 * To begin with: {@link haltere.filters.wing.tracker.WingTracker}.
 */
package haltere.filters.wing.tracker;
