/** The sensor of all scenes: pixels, noise and the order of their events. */
package haltere.core.simulation.internal.sensor;
