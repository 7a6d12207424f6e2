package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import java.io.IOException;

/** Publishes lines to subscribers of ZeroMQ: {@code zmq://host:port}. */
public final class ZeroMqLinesProvider implements LineOutputProvider {
  /** Called by the service loader. */
  public ZeroMqLinesProvider() {}

  @Override
  public String scheme() {
    return "zmq";
  }

  @Override
  public String description() {
    return "Publishes at the host and port as a ZeroMQ PUB socket; receivers subscribe to stage/outlet.";
  }

  @Override
  public LineOutput open(LineAddress address) throws IOException {
    return new TcpLines(address, new ZmtpProtocol(), TcpReceiver.ROOM_LINES);
  }
}
