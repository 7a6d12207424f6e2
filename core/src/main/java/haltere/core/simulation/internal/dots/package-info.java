/** Moving discs that meet and separate, and their truth. */
package haltere.core.simulation.internal.dots;
