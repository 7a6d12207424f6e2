/**
 * The data of a stream: packets of polarity events, their packed addresses and the geometry of
 * their sensor. Depends on no other package of Haltere.
 */
package haltere.core.event;
