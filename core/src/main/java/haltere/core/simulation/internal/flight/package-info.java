/** A fly in free flight before several cameras, and its truth. */
package haltere.core.simulation.internal.flight;
