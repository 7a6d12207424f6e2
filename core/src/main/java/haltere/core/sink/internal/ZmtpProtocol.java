package haltere.core.sink.internal;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The publisher's side of ZMTP 3.0, which ZeroMQ since version 4 speaks, without authentication
 * (mechanism NULL); the layout is that of ZeroMQ's RFC 23. A line is a message of two frames, its
 * topic and itself.
 */
final class ZmtpProtocol implements LineProtocol {
  static final int MORE = 1;
  static final int LONG = 2;
  static final int COMMAND = 4;

  /** A peer that has not introduced itself after this time is disconnected. */
  private static final int GREETING_MS = 5000;

  private static final int MAX_SHORT_BYTES = 255;

  private final int greetingMs;

  ZmtpProtocol() {
    this(GREETING_MS);
  }

  ZmtpProtocol(int greetingMs) {
    this.greetingMs = greetingMs;
  }

  @Override
  public byte[] frame(byte[] topic, byte[] line) {
    ByteBuffer message = ByteBuffer.allocate(frameBytes(topic) + frameBytes(line));
    putFrame(message, MORE, topic);
    putFrame(message, 0, line);
    return message.array();
  }

  /** A command: its name and data. */
  static byte[] command(String name, byte[] data) {
    ByteBuffer body = ByteBuffer.allocate(1 + name.length() + data.length);
    body.put((byte) name.length()).put(name.getBytes(StandardCharsets.US_ASCII)).put(data);
    ByteBuffer frame = ByteBuffer.allocate(frameBytes(body.array()));
    putFrame(frame, COMMAND, body.array());
    return frame.array();
  }

  private static int frameBytes(byte[] body) {
    return 1 + (body.length > MAX_SHORT_BYTES ? Long.BYTES : 1) + body.length;
  }

  private static void putFrame(ByteBuffer to, int flags, byte[] body) {
    if (body.length > MAX_SHORT_BYTES) {
      to.put((byte) (flags | LONG)).putLong(body.length);
    } else {
      to.put((byte) flags).put((byte) body.length);
    }
    to.put(body);
  }

  @Override
  public Peer peerOf(Socket socket) throws IOException {
    return new ZmtpPeer(socket, greetingMs);
  }

  @Override
  public byte[] refusal(String why) {
    return new byte[0];
  }
}
