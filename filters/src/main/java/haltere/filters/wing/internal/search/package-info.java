/**
 * Finds a fly and its strokes in the events of a few beats, and notices a fly that was found at a
 * multiple of its frequency. To begin with: {@link haltere.filters.wing.internal.search.FlySearch};
 * what it does is in {@code FlyFinder}.
 *
 * <p>Thread rule of all classes here: one thread at a time.
 */
package haltere.filters.wing.internal.search;
