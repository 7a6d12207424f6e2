package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import java.io.IOException;

/** Listens at {@code tcp://host:port} and sends every line to each client. */
public final class TcpLinesProvider implements LineOutputProvider {
  /** Called by the service loader. */
  public TcpLinesProvider() {}

  @Override
  public String scheme() {
    return "tcp";
  }

  @Override
  public String description() {
    return "Listens at the host and port and sends every line to each program that connects.";
  }

  @Override
  public LineOutput open(LineAddress address) throws IOException {
    return new TcpLines(address, new PlainProtocol(), TcpReceiver.ROOM_LINES);
  }
}
