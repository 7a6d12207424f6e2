/**
 * The filter contract, the chain of filters, typed outlets for results and the services by which
 * filters are found.
 */
package haltere.core.chain;
