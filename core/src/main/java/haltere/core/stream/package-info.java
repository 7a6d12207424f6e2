/**
 * Event streams: a source hands packets and in-band notifications to a handler, one at a time and
 * in order.
 */
package haltere.core.stream;
