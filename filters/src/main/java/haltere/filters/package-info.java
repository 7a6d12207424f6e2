/** Filters that come with Haltere, and the chain to start from. */
package haltere.filters;
