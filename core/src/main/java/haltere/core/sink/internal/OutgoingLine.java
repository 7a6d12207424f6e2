package haltere.core.sink.internal;

/**
 * Data queued for a receiver.
 *
 * @param bytes as sent over the connection; immutable
 * @param counted whether it counts as lost if it is not sent: true for a line, false for an answer
 *     of the protocol
 */
record OutgoingLine(byte[] bytes, boolean counted) {}
