/**
 * Tracks of things that move: which measurement belongs to which track, and where on the road an
 * image position lies. Nothing here knows the chain.
 */
package haltere.filters.track;
