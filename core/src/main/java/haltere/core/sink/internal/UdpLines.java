package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;

/**
 * Sends each line as a datagram. A receiver is not required; a line that the system cannot buffer
 * is counted as lost.
 */
final class UdpLines implements LineOutput {
  private final LineAddress address;
  private final InetSocketAddress target;
  private final DatagramChannel channel;
  private volatile long lost;

  UdpLines(LineAddress address) throws IOException {
    this.address = address;
    target = new InetSocketAddress(address.host(), address.port());
    if (target.isUnresolved()) {
      throw new IOException(address + ": there is no host of this name");
    }
    channel = DatagramChannel.open();
    channel.configureBlocking(false);
  }

  @Override
  public String address() {
    return address.toString();
  }

  @Override
  public void send(String topic, byte[] line) {
    int sent = 0;
    try {
      sent = channel.send(ByteBuffer.wrap(line), target);
    } catch (IOException ignored) {
      // lost, as a datagram in transit may be
    }
    if (sent == 0) {
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
    try {
      channel.close();
    } catch (IOException ignored) {
      // datagrams do not wait
    }
  }
}
