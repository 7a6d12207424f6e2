package haltere.core.sink.internal;

import haltere.core.sink.LiveMessages;
import haltere.core.stream.internal.Daemon;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.Consumer;

/**
 * A receiver of lines over TCP, with its queue and writing thread.
 *
 * <p>Thread rule: one thread offers lines; the rest may be called from any.
 */
final class TcpReceiver {
  /** Maximum number of queued lines: about 2 MB. */
  static final int ROOM_LINES = 8192;

  static final byte[] NOTIFICATION = "notification".getBytes(StandardCharsets.US_ASCII);

  private static final int BATCH_BYTES = 1 << 15;
  private static final OutgoingLine END = new OutgoingLine(new byte[0], false);

  private final Socket socket;
  private final LineProtocol protocol;
  private final LineProtocol.Peer peer;
  private final Consumer<TcpReceiver> left;
  private final BlockingQueue<OutgoingLine> waiting;
  private final LiveMessages messages = new LiveMessages(Clock.systemUTC());
  private final Thread thread;
  private final Object counts = new Object();
  private long lost;
  private long unreported;

  /** Lines taken from the queue that the system has not yet accepted. */
  private volatile long underway;

  private volatile boolean ending;

  TcpReceiver(Socket socket, LineProtocol protocol, int roomLines, Consumer<TcpReceiver> left)
      throws IOException {
    this.socket = socket;
    this.protocol = protocol;
    this.left = left;
    peer = protocol.peerOf(socket);
    waiting = new ArrayBlockingQueue<>(roomLines);
    socket.setTcpNoDelay(true);
    thread = Daemon.thread(this::work, "haltere-publish-" + socket.getRemoteSocketAddress());
  }

  /** Starts writing. */
  void start() {
    thread.start();
  }

  /** Whether lines on a topic are for this receiver. */
  boolean wants(byte[] topic) {
    return peer.wants(topic);
  }

  /** Whether any lines are for this receiver. */
  boolean receives() {
    return peer.receives();
  }

  /** Queues a line, or counts it as lost if the queue is full. */
  void offer(OutgoingLine line) {
    synchronized (counts) {
      // losses are reported before newer lines
      if (unreported > 0 && waiting.remainingCapacity() > 1) {
        waiting.add(new OutgoingLine(takeLossMessage(), false));
      }
      if (unreported > 0 || !waiting.offer(line)) {
        lost++;
        unreported++;
      }
    }
  }

  private byte[] takeLossMessage() {
    synchronized (counts) {
      boolean isReported = unreported > 0 && peer.wants(NOTIFICATION);
      byte[] message =
          isReported
              ? protocol.frame(
                  NOTIFICATION, messages.lost(unreported, "this receiver was too slow"))
              : END.bytes();
      unreported = 0;
      return message;
    }
  }

  /** Lines lost because the queue was full. */
  long lost() {
    synchronized (counts) {
      return lost;
    }
  }

  private void work() {
    try (socket) {
      peer.greet();
      if (peer.sendsData()) {
        Daemon.thread(this::listen, thread.getName() + "-in").start();
      }
      write(socket.getOutputStream());
    } catch (IOException | InterruptedException ignored) {
      // the receiver has disconnected, or is not waited for
    } finally {
      left.accept(this);
    }
  }

  private void write(OutputStream out) throws IOException, InterruptedException {
    ByteArrayOutputStream batch = new ByteArrayOutputStream(2 * BATCH_BYTES);
    while (true) {
      // read before the queue, so that lines queued before the end are still written
      boolean nothingFollows = ending;
      OutgoingLine line = batch.size() < BATCH_BYTES ? waiting.poll() : null;
      if (line == null && batch.size() == 0) {
        if (nothingFollows) {
          out.write(takeLossMessage());
          return;
        }
        line = waiting.take();
      }
      if (line != null) {
        batch.write(line.bytes());
        underway = line.counted() ? underway + 1 : underway;
      } else {
        batch.writeTo(out);
        batch.reset();
        underway = 0;
      }
    }
  }

  private void listen() {
    try {
      peer.listen(bytes -> waiting.offer(new OutgoingLine(bytes, false)));
    } catch (IOException ignored) {
      stop();
    }
  }

  private void stop() {
    try {
      socket.close();
    } catch (IOException ignored) {
      // the receiver has disconnected
    }
    thread.interrupt();
  }

  /** Has it end when all that waits is written. */
  void finish() {
    ending = true;
    waiting.offer(END);
  }

  /**
   * Waits for the end, for so long at the most, and says how many lines are still to be written.
   */
  int await(long timeoutMs) throws InterruptedException {
    thread.join(timeoutMs);
    return thread.isAlive() ? waiting.size() + 1 : 0;
  }

  /** Ends at once; what was not taken is counted as lost. */
  void abandon() {
    if (thread.isAlive()) {
      synchronized (counts) {
        lost += underway + waiting.stream().filter(OutgoingLine::counted).count();
      }
    }
    stop();
  }
}
