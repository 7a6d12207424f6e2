/**
 * Shared by all decoders: cursors over the events of a file, decoders of a stream, the guess of a
 * sensor.
 */
package haltere.core.format.internal.decoding;
