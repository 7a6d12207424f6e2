/** A tethered fly that beats its wings, and its truth. */
package haltere.core.simulation.internal.fly;
