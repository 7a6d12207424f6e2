/** One chain over many recordings: inputs, shards, and results that are written exactly once. */
package haltere.core.batch;
