/**
 * Shared by all decoders: cursors over the events of a file, decoders of a stream, the estimate of
 * a sensor size.
 */
package haltere.core.format.internal.decoding;
