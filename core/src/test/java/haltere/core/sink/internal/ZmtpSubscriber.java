package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Optional;

/**
 * A subscriber of ZeroMQ, byte by byte as RFC 23 and RFC 37 have it. It knows nothing of the
 * sender's classes; a test with Python's pyzmq has the real one.
 */
final class ZmtpSubscriber implements AutoCloseable {
  /** Signature, version 3.0, mechanism NULL, client. */
  static final String GREETING =
      "ff00000000000000017f0300"
          + "4e554c4c00000000000000000000000000000000"
          + "0000000000000000000000000000000000000000000000000000000000000000";

  /** The command READY of a socket of type SUB. */
  static final String READY =
      "0419" + "055245414459" + "0b536f636b65742d54797065" + "00000003535542";

  private static final int GREETING_BYTES = 64;
  private static final int READY_BYTES = 2 + 6 + 12 + 4 + 3;
  private static final int PATIENCE_MS = 30_000;
  private static final int LONG = 2;
  private static final byte SUBSCRIBE = 1;

  /** A message of two frames. */
  record Message(String topic, String line) {}

  private final Socket socket = new Socket();
  private final DataInputStream in;

  /** One that has been greeted; it holds few bytes that nobody has asked for. */
  ZmtpSubscriber(LineOutput output) throws IOException {
    this(output.address(), 1);
  }

  /** One that has been greeted and holds so many bytes that nobody has asked for. */
  ZmtpSubscriber(String address, int receiveBufferBytes) throws IOException {
    socket.setReceiveBufferSize(receiveBufferBytes);
    socket.setSoTimeout(PATIENCE_MS);
    socket.connect(new InetSocketAddress("127.0.0.1", LineAddress.parse(address).port()));
    in = new DataInputStream(new BufferedInputStream(socket.getInputStream()));
    write(GREETING + READY);
    in.readFully(new byte[GREETING_BYTES + READY_BYTES]);
  }

  /** Subscribes to the topics that begin so. */
  ZmtpSubscriber to(String topic) throws IOException {
    byte[] prefix = topic.getBytes(StandardCharsets.UTF_8);
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    message.write(new byte[] {0, (byte) (1 + prefix.length), SUBSCRIBE});
    message.write(prefix);
    socket.getOutputStream().write(message.toByteArray());
    return this;
  }

  /** Says something; hexadecimal. */
  void write(String bytes) throws IOException {
    socket.getOutputStream().write(HexFormat.of().parseHex(bytes));
  }

  /** So many of the next bytes. */
  byte[] read(int bytes) throws IOException {
    byte[] next = new byte[bytes];
    in.readFully(next);
    return next;
  }

  /** The next message. */
  Message receive() throws IOException {
    return new Message(frame(in.read()), frame(in.read()));
  }

  /** The next message, empty if none begins within a time. */
  Optional<Message> receive(int withinMs) throws IOException {
    socket.setSoTimeout(withinMs);
    int flags;
    try {
      flags = in.read();
    } catch (SocketTimeoutException none) {
      return Optional.empty();
    } finally {
      socket.setSoTimeout(PATIENCE_MS);
    }
    return Optional.of(new Message(frame(flags), frame(in.read())));
  }

  private String frame(int flags) throws IOException {
    long bytes = (flags & LONG) != 0 ? in.readLong() : in.readUnsignedByte();
    return new String(read(Math.toIntExact(bytes)), StandardCharsets.UTF_8);
  }

  Socket socket() {
    return socket;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
