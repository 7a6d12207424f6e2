/**
 * One chain over many recordings: which they are, who works on which, and results that are complete
 * once and never twice.
 */
package haltere.core.batch;
