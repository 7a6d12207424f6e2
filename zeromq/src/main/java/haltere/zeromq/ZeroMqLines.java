package haltere.zeromq;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;
import org.zeromq.ZMQException;

/**
 * A ZeroMQ socket of type PUB. A peer sends nothing but subscriptions, so one that claims a longer
 * message than {@value #MAX_RECEIVED_BYTES} bytes is disconnected before memory is taken for it.
 * Each line is a message of two frames, its topic and itself. For a subscriber that is too slow
 * ZeroMQ drops lines beyond those that have room, without a word: the numbers of the messages tell.
 *
 * <p>Thread rule: opened anywhere, sent to and closed by one thread.
 */
final class ZeroMqLines implements LineOutput {
  private static final int ROOM_LINES = 8192;
  private static final int PATIENCE_MS = 1000;

  /** Longer than any topic. */
  private static final int MAX_RECEIVED_BYTES = 4096;

  /** A peer that has not introduced itself after this time is disconnected. */
  private static final int HANDSHAKE_MS = 5000;

  private final LineAddress address;
  private final ZContext context = new ZContext(1);
  private final ZMQ.Socket socket;
  private volatile long lost;
  private volatile String failure;

  ZeroMqLines(LineAddress address) throws IOException {
    context.setLinger(PATIENCE_MS);
    context.setUncaughtExceptionHandler((thread, fault) -> failed(fault));
    socket = context.createSocket(SocketType.PUB);
    socket.setSndHWM(ROOM_LINES);
    socket.setMaxMsgSize(MAX_RECEIVED_BYTES);
    socket.setHandshakeIvl(HANDSHAKE_MS);
    socket.setLinger(PATIENCE_MS);
    try {
      socket.bind(new LineAddress("tcp", address.host(), address.port()).toString());
    } catch (ZMQException | IllegalArgumentException refused) {
      context.close();
      throw new IOException(address + ": cannot listen here: " + refused.getMessage(), refused);
    }
    String bound = socket.getLastEndpoint();
    this.address = address.withPort(Integer.parseInt(bound.substring(bound.lastIndexOf(':') + 1)));
  }

  @Override
  public String address() {
    return address.toString();
  }

  @Override
  public void send(String topic, byte[] line) {
    if (failure != null) {
      lost++;
      return;
    }
    try {
      boolean sent =
          socket.send(topic.getBytes(StandardCharsets.UTF_8), ZMQ.SNDMORE | ZMQ.DONTWAIT)
              && socket.send(line, ZMQ.DONTWAIT);
      if (!sent) {
        lost++;
      }
    } catch (ZMQException fault) {
      lost++;
      failed(fault);
    }
  }

  /** Called by the library when one of its threads ends with a fault. */
  void failed(Throwable fault) {
    failure = "ZeroMQ failed: " + fault;
  }

  @Override
  public Optional<String> failure() {
    return Optional.ofNullable(failure);
  }

  @Override
  public int receivers() {
    return -1;
  }

  @Override
  public long lost() {
    return lost;
  }

  @Override
  public void close() {
    context.close();
  }
}
