/**
 * Decoders of camera data to events and samples: state machines without input or output, for USB
 * and files alike.
 */
package haltere.device.protocol;
