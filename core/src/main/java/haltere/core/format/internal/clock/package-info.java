/** Times of recordings: clocks that wrap or go back, and their relation to the times of a file. */
package haltere.core.format.internal.clock;
