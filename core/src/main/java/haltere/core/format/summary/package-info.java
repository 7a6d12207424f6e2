/** Summaries of a recording from one pass: counts, rates, gaps. */
package haltere.core.format.summary;
