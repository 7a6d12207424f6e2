/**
 * What flows: packets of polarity events, their packed addresses and the geometry of the sensor
 * they come from. Knows nothing else of Haltere.
 */
package haltere.core.event;
