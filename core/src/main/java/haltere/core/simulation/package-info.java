/** Simulated scenes: sources with known answers, seeded and streaming. */
package haltere.core.simulation;
