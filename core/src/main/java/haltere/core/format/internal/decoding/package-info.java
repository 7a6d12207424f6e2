/**
 * What all decoders share: cursors over the events of a file, decoders of a stream, what is guessed
 * of a sensor.
 */
package haltere.core.format.internal.decoding;
