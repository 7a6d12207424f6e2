package haltere.core.sink.internal;

/**
 * What waits for a receiver.
 *
 * @param bytes as they go over the connection; not changed by anyone
 * @param counted whether it is missed if it is not sent: a line is, an answer of the protocol is
 *     not
 */
record OutgoingLine(byte[] bytes, boolean counted) {}
