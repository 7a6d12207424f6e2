/** A road seen from a bridge, with vehicles in perspective, and their truth. */
package haltere.core.simulation.internal.road;
