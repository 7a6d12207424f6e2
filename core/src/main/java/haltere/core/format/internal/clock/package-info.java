/**
 * Times of recordings: clocks that wrap or go back, and how far apart they are from the times of a
 * file.
 */
package haltere.core.format.internal.clock;
