/** Runs source, chain and sinks on one processing thread, and counts every loss. */
package haltere.core.pipeline;
