/** Runs it all on one processing thread: source, chain, sinks, with every loss counted. */
package haltere.core.pipeline;
