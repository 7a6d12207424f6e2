package haltere.core.sink;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * Listens, and sends every line to each who connects. Each receiver has room of its own for lines
 * that wait, so that a slow one costs only itself.
 */
final class TcpLines implements LineOutput {
  private static final long PATIENCE_MS = 1000;
  private static final long REST_NANOS = 10_000_000;

  private final LineAddress address;
  private final int roomLines;
  private final ServerSocket server;
  private final List<TcpReceiver> receivers = new CopyOnWriteArrayList<>();
  private final AtomicLong lostByThoseWhoLeft = new AtomicLong();
  private volatile boolean closed;

  TcpLines(LineAddress address, int roomLines) throws IOException {
    this.roomLines = roomLines;
    server = new ServerSocket();
    try {
      server.setReuseAddress(true);
      server.bind(
          address.host().equals("*")
              ? new InetSocketAddress(address.port())
              : new InetSocketAddress(address.host(), address.port()));
    } catch (IOException | RuntimeException refused) {
      server.close();
      throw new IOException(address + ": cannot listen here: " + refused.getMessage(), refused);
    }
    this.address = address.withPort(server.getLocalPort());
    Thread thread = new Thread(this::accept, "haltere-publish-accept");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!closed) {
      try {
        TcpReceiver receiver = new TcpReceiver(server.accept(), roomLines, this::left);
        receivers.add(receiver);
        receiver.start();
      } catch (IOException notThisOne) {
        // it has gone again, this output is being closed, or there are no more sockets for now
        LockSupport.parkNanos(REST_NANOS);
      }
    }
  }

  private void left(TcpReceiver receiver) {
    if (receivers.remove(receiver)) {
      lostByThoseWhoLeft.addAndGet(receiver.lost());
    }
  }

  @Override
  public String address() {
    return address.toString();
  }

  @Override
  public void send(String topic, byte[] line) {
    for (TcpReceiver receiver : receivers) {
      receiver.offer(line);
    }
  }

  @Override
  public int receivers() {
    return receivers.size();
  }

  @Override
  public long lost() {
    long lost = lostByThoseWhoLeft.get();
    for (TcpReceiver receiver : receivers) {
      lost += receiver.lost();
    }
    return lost;
  }

  @Override
  public void close() {
    closed = true;
    try {
      server.close();
    } catch (IOException nothingToSave) {
      // nobody can connect any more
    }
    for (TcpReceiver receiver : receivers) {
      receiver.finish(PATIENCE_MS);
    }
  }
}
