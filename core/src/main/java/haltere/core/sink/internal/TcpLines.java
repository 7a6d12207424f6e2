package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.stream.internal.Daemon;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * Listens, and sends every line to each client. Each receiver has its own queue, so that a slow one
 * does not affect others.
 */
final class TcpLines implements LineOutput {
  /** Each receiver has a thread and a queue of about 2 MB. */
  static final int MAX_RECEIVERS = 64;

  private static final long TIMEOUT_MS = 1000;
  private static final long REST_NANOS = 10_000_000;

  private final LineAddress address;
  private final LineProtocol protocol;
  private final int roomLines;
  private final ServerSocket server;
  private final List<TcpReceiver> receivers = new CopyOnWriteArrayList<>();
  private final AtomicLong lostByDisconnected = new AtomicLong();
  private final AtomicLong refused = new AtomicLong();
  private volatile boolean closed;

  TcpLines(LineAddress address, LineProtocol protocol, int roomLines) throws IOException {
    this.protocol = protocol;
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
    Daemon.thread(this::accept, "haltere-publish-accept").start();
  }

  private void accept() {
    while (!closed) {
      try {
        Socket socket = server.accept();
        if (receivers.size() < MAX_RECEIVERS) {
          take(socket);
        } else {
          refuse(socket);
        }
      } catch (IOException ignored) {
        // the client has disconnected, this output is being closed, or no socket is free
        LockSupport.parkNanos(REST_NANOS);
      }
    }
  }

  private void take(Socket socket) throws IOException {
    try {
      TcpReceiver receiver = new TcpReceiver(socket, protocol, roomLines, this::left);
      receivers.add(receiver);
      receiver.start();
    } catch (IOException disconnected) {
      socket.close();
      throw disconnected;
    }
  }

  private void refuse(Socket socket) throws IOException {
    refused.incrementAndGet();
    try (socket) {
      String place = MAX_RECEIVERS + " receivers are connected, the maximum";
      socket.getOutputStream().write(protocol.refusal(place));
    }
  }

  @Override
  public long refused() {
    return refused.get();
  }

  private void left(TcpReceiver receiver) {
    if (receivers.remove(receiver)) {
      lostByDisconnected.addAndGet(receiver.lost());
    }
  }

  @Override
  public String address() {
    return address.toString();
  }

  @Override
  public void send(String topic, byte[] line) {
    byte[] topicBytes = topic.getBytes(StandardCharsets.UTF_8);
    OutgoingLine outgoing = null;
    for (TcpReceiver receiver : receivers) {
      if (receiver.wants(topicBytes)) {
        outgoing =
            outgoing == null ? new OutgoingLine(protocol.frame(topicBytes, line), true) : outgoing;
        receiver.offer(outgoing);
      }
    }
  }

  @Override
  public int receivers() {
    int count = 0;
    for (TcpReceiver receiver : receivers) {
      count += receiver.receives() ? 1 : 0;
    }
    return count;
  }

  @Override
  public long lost() {
    long lost = lostByDisconnected.get();
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
    } catch (IOException ignored) {
      // no client can connect any more
    }
    receivers.forEach(TcpReceiver::finish);
    try {
      await();
    } catch (InterruptedException ignored) {
      Thread.currentThread().interrupt();
    }
    receivers.forEach(TcpReceiver::abandon);
  }

  /** Waits while any receiver accepts data. */
  private void await() throws InterruptedException {
    long before;
    long now = Long.MAX_VALUE;
    do {
      before = now;
      now = 0;
      long endNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(TIMEOUT_MS);
      for (TcpReceiver receiver : receivers) {
        long leftMs = TimeUnit.NANOSECONDS.toMillis(endNanos - System.nanoTime());
        now += receiver.await(Math.max(1, leftMs));
      }
    } while (now > 0 && now < before);
  }
}
