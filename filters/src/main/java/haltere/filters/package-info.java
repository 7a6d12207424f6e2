/** Filters of Haltere, and its default chains. */
package haltere.filters;
