package haltere.zeromq;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;
import org.zeromq.ZMQException;

/**
 * A ZeroMQ socket of type PUB. Each line is a message of two frames, its topic and itself. For a
 * subscriber that is too slow ZeroMQ drops lines beyond those that have room, without a word: the
 * numbers of the messages tell.
 *
 * <p>Thread rule: opened anywhere, sent to and closed by one thread.
 */
final class ZeroMqLines implements LineOutput {
  private static final int ROOM_LINES = 8192;
  private static final int PATIENCE_MS = 1000;

  private final LineAddress address;
  private final ZContext context = new ZContext(1);
  private final ZMQ.Socket socket;
  private volatile long lost;

  ZeroMqLines(LineAddress address) throws IOException {
    context.setLinger(PATIENCE_MS);
    socket = context.createSocket(SocketType.PUB);
    socket.setSndHWM(ROOM_LINES);
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
    boolean sent =
        socket.send(topic.getBytes(StandardCharsets.UTF_8), ZMQ.SNDMORE | ZMQ.DONTWAIT)
            && socket.send(line, ZMQ.DONTWAIT);
    if (!sent) {
      lost++;
    }
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
