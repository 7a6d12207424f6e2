/** A tethered fly that beats its wings before the camera, and its truth. */
package haltere.core.simulation.internal.fly;
