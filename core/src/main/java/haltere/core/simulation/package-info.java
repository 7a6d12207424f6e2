/** Simulated scenes: seeded, streaming sources with ground truth. */
package haltere.core.simulation;
