/** Discs that move, meet and part, and their truth. */
package haltere.core.simulation.internal.dots;
