/**
 * What cameras send, bytes to events and readings: state machines without a cable, fed by a file as
 * well as by USB.
 */
package haltere.device.protocol;
