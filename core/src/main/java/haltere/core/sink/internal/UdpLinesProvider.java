package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import java.io.IOException;

/** Sends each line as a datagram: {@code udp://host:port}. */
public final class UdpLinesProvider implements LineOutputProvider {
  /** Called by the service loader. */
  public UdpLinesProvider() {}

  @Override
  public String scheme() {
    return "udp";
  }

  @Override
  public String description() {
    return "Sends each line as a datagram to the host and port.";
  }

  @Override
  public void check(LineAddress address) {
    if (address.port() == 0) {
      throw new IllegalArgumentException(address + ": datagrams need the port of their receiver");
    }
  }

  @Override
  public LineOutput open(LineAddress address) throws IOException {
    return new UdpLines(address);
  }
}
