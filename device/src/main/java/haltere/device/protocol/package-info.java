/**
 * What cameras send, bytes to events and samples: state machines without a cable, fed by a file as
 * well as by USB.
 */
package haltere.device.protocol;
