/**
 * Search of a fly and its strokes in the events of a few beats, and detection of a lock at a
 * multiple of its frequency. Start with {@link haltere.filters.wing.internal.search.FlySearch} and
 * {@code FlyFinder}.
 *
 * <p>Thread rule of all classes here: one thread at a time.
 */
package haltere.filters.wing.internal.search;
