/** What one pass over a recording tells of it: counts, rates, gaps. */
package haltere.core.format.summary;
