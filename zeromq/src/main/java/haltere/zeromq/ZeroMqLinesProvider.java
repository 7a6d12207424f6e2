package haltere.zeromq;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import java.io.IOException;

/** Publishes lines from a ZeroMQ socket of type PUB: {@code zmq://host:port}. */
public final class ZeroMqLinesProvider implements LineOutputProvider {
  /** Called by the service loader. */
  public ZeroMqLinesProvider() {}

  @Override
  public String scheme() {
    return "zmq";
  }

  @Override
  public String description() {
    return "Binds a ZeroMQ PUB socket to the host and port; receivers subscribe to stage/outlet.";
  }

  @Override
  public LineOutput open(LineAddress address) throws IOException {
    return new ZeroMqLines(address);
  }
}
