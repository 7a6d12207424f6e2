package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LiveMessages;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Clock;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * Listens, and sends every line to each who connects. Each receiver has room of its own for lines
 * that wait, so that a slow one costs only itself.
 */
final class TcpLines implements LineOutput {
  /** Each receiver has a thread and room for some 2 MB of lines. */
  static final int MAX_RECEIVERS = 64;

  private static final long PATIENCE_MS = 1000;
  private static final long REST_NANOS = 10_000_000;

  private final LineAddress address;
  private final int roomLines;
  private final ServerSocket server;
  private final List<TcpReceiver> receivers = new CopyOnWriteArrayList<>();
  private final AtomicLong lostByThoseWhoLeft = new AtomicLong();
  private final AtomicLong refused = new AtomicLong();
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
        Socket socket = server.accept();
        if (receivers.size() < MAX_RECEIVERS) {
          TcpReceiver receiver = new TcpReceiver(socket, roomLines, this::left);
          receivers.add(receiver);
          receiver.start();
        } else {
          refuse(socket);
        }
      } catch (IOException notThisOne) {
        // it has gone again, this output is being closed, or there are no more sockets for now
        LockSupport.parkNanos(REST_NANOS);
      }
    }
  }

  private void refuse(Socket socket) throws IOException {
    refused.incrementAndGet();
    try (socket) {
      String place = MAX_RECEIVERS + " receivers are connected, and there may be no more";
      socket.getOutputStream().write(new LiveMessages(Clock.systemUTC()).refused(place));
    }
  }

  @Override
  public long refused() {
    return refused.get();
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
