package haltere.core.sink.internal;

import java.io.IOException;
import java.net.ProtocolException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * A subscriber of ZeroMQ. It may send a greeting and subscriptions only: a slow greeting, a long
 * frame or more than {@value #MAX_SUBSCRIPTIONS} subscriptions end the connection.
 *
 * <p>Thread rule: one thread greets, and then one listens; the rest may be called from any.
 */
final class ZmtpPeer implements LineProtocol.Peer {
  /** Limit far above the number of outlets. */
  static final int MAX_SUBSCRIPTIONS = 1024;

  private static final int GREETING_BYTES = 64;
  private static final int VERSION = 3;
  private static final int VERSION_AT = 10;
  private static final int MECHANISM_AT = 12;
  private static final int MECHANISM_BYTES = 20;
  private static final String MECHANISM = "NULL";
  private static final int PING_TTL_BYTES = 2;
  private static final byte SUBSCRIBE = 1;
  private static final byte CANCEL = 0;

  private final Socket socket;
  private final ZmtpInput in;
  private final List<byte[]> subscriptions = new CopyOnWriteArrayList<>();

  ZmtpPeer(Socket socket, int greetingMs) throws IOException {
    this.socket = socket;
    in = new ZmtpInput(socket, greetingMs);
  }

  @Override
  public void greet() throws IOException {
    socket.getOutputStream().write(greeting());
    byte[] signature = in.read(VERSION_AT);
    if (signature[0] != (byte) 0xFF || (signature[VERSION_AT - 1] & 1) == 0) {
      throw new ProtocolException("it does not speak ZMTP");
    }
    if (in.read(1)[0] < VERSION) {
      throw new ProtocolException("it does not speak ZMTP " + VERSION);
    }
    ByteBuffer rest = ByteBuffer.wrap(in.read(GREETING_BYTES - VERSION_AT - 1));
    rest.position(MECHANISM_AT - VERSION_AT - 1);
    if (!ZmtpInput.text(rest, MECHANISM_BYTES).trim().equals(MECHANISM)) {
      throw new ProtocolException("it requires authentication");
    }
    byte[] ready = ZmtpProtocol.command("READY", property("Socket-Type", "PUB"));
    socket.getOutputStream().write(ready);
    ZmtpInput.ZmtpFrame reply = in.readFrame();
    if (!reply.command().equals("READY") || !subscribes(ByteBuffer.wrap(reply.data()))) {
      throw new ProtocolException("it is not a subscriber");
    }
    in.removeTimeLimit();
  }

  private static byte[] greeting() {
    ByteBuffer greeting = ByteBuffer.allocate(GREETING_BYTES);
    greeting.put(0, (byte) 0xFF).put(VERSION_AT - 1, (byte) 0x7F).put(VERSION_AT, (byte) VERSION);
    greeting.position(MECHANISM_AT);
    return greeting.put(MECHANISM.getBytes(StandardCharsets.US_ASCII)).array();
  }

  private static byte[] property(String name, String value) {
    ByteBuffer property = ByteBuffer.allocate(1 + name.length() + Integer.BYTES + value.length());
    property.put((byte) name.length()).put(name.getBytes(StandardCharsets.US_ASCII));
    property.putInt(value.length()).put(value.getBytes(StandardCharsets.US_ASCII));
    return property.array();
  }

  private static boolean subscribes(ByteBuffer properties) throws ProtocolException {
    while (properties.remaining() > Integer.BYTES) {
      String name = ZmtpInput.text(properties, properties.get() & 0xFF);
      int bytes = properties.remaining() < Integer.BYTES ? -1 : properties.getInt();
      String value = ZmtpInput.text(properties, bytes);
      if (name.equalsIgnoreCase("Socket-Type")) {
        return value.equals("SUB") || value.equals("XSUB");
      }
    }
    return false;
  }

  @Override
  public boolean sendsData() {
    return true;
  }

  @Override
  public void listen(Consumer<byte[]> answers) throws IOException {
    while (true) {
      ZmtpInput.ZmtpFrame frame = in.readFrame();
      byte[] data = frame.data();
      switch (frame.command()) {
        case "SUBSCRIBE" -> subscribe(data);
        case "CANCEL" -> cancel(data);
        case "PING" -> answers.accept(ZmtpProtocol.command("PONG", behind(data, PING_TTL_BYTES)));
        case "" -> message(data);
        default -> {}
      }
    }
  }

  /** Up to ZMTP 3.0 a subscription is a message. */
  private void message(byte[] data) throws IOException {
    if (data.length > 0 && data[0] == SUBSCRIBE) {
      subscribe(behind(data, 1));
    } else if (data.length > 0 && data[0] == CANCEL) {
      cancel(behind(data, 1));
    }
  }

  private static byte[] behind(byte[] data, int from) {
    return Arrays.copyOfRange(data, Math.min(from, data.length), data.length);
  }

  private void subscribe(byte[] prefix) throws IOException {
    if (subscriptions.stream().noneMatch(known -> Arrays.equals(known, prefix))) {
      if (subscriptions.size() == MAX_SUBSCRIPTIONS) {
        throw new ProtocolException("more than " + MAX_SUBSCRIPTIONS + " subscriptions");
      }
      subscriptions.add(prefix);
    }
  }

  private void cancel(byte[] prefix) {
    subscriptions.removeIf(known -> Arrays.equals(known, prefix));
  }

  @Override
  public boolean wants(byte[] topic) {
    for (byte[] prefix : subscriptions) {
      if (prefix.length <= topic.length
          && Arrays.equals(prefix, 0, prefix.length, topic, 0, prefix.length)) {
        return true;
      }
    }
    return false;
  }

  @Override
  public boolean receives() {
    return !subscriptions.isEmpty();
  }
}
