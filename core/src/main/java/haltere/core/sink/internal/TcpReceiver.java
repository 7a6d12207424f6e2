package haltere.core.sink.internal;

import haltere.core.sink.LiveMessages;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.time.Clock;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * One who receives lines over TCP, with the lines that wait for it and the thread that writes them.
 *
 * <p>Thread rule: one thread offers lines; the rest may be called from any.
 */
final class TcpReceiver {
  /** Lines that wait for a receiver at the most: about 2 MB. */
  static final int ROOM_LINES = 8192;

  private static final byte[] END = {};

  private final Socket socket;
  private final Consumer<TcpReceiver> left;
  private final BlockingQueue<byte[]> waiting;
  private final LiveMessages messages = new LiveMessages(Clock.systemUTC());
  private final Thread thread;
  private final Object counts = new Object();
  private long lost;
  private long untold;
  private volatile boolean ending;

  TcpReceiver(Socket socket, int roomLines, Consumer<TcpReceiver> left) throws IOException {
    this.socket = socket;
    this.left = left;
    waiting = new ArrayBlockingQueue<>(roomLines);
    socket.setTcpNoDelay(true);
    thread = new Thread(this::work, "haltere-publish-" + socket.getRemoteSocketAddress());
    thread.setDaemon(true);
  }

  /** Begins to write. */
  void start() {
    thread.start();
  }

  /** Takes a line if there is room for it, and counts it if not. */
  void offer(byte[] line) {
    synchronized (counts) {
      // what is missing is told before anything newer
      if (untold > 0 && waiting.remainingCapacity() > 1) {
        waiting.add(messages.lost(untold, "this receiver was too slow"));
        untold = 0;
      }
      if (untold > 0 || !waiting.offer(line)) {
        lost++;
        untold++;
      }
    }
  }

  /** Lines for which there was no room. */
  long lost() {
    synchronized (counts) {
      return lost;
    }
  }

  private void work() {
    try (socket;
        OutputStream out = new BufferedOutputStream(socket.getOutputStream(), 1 << 15)) {
      while (true) {
        // asked for before the queue: what was put there before the end began is still written
        boolean nothingFollows = ending;
        byte[] line = waiting.poll();
        if (line == null) {
          out.flush();
          if (nothingFollows) {
            return;
          }
          line = waiting.take();
        }
        out.write(line);
      }
    } catch (IOException | InterruptedException gone) {
      // it does not want any more, or is not waited for
    } finally {
      left.accept(this);
    }
  }

  /**
   * Ends when all that waits is written, or when the receiver has taken nothing for a while: what
   * it did not take is counted as lost.
   */
  void finish(long patienceMs) {
    try {
      synchronized (counts) {
        if (untold > 0) {
          byte[] line = messages.lost(untold, "this receiver was too slow");
          waiting.offer(line, patienceMs, TimeUnit.MILLISECONDS);
        }
      }
      ending = true;
      waiting.offer(END);
      int left;
      do {
        left = waiting.size();
        thread.join(patienceMs);
      } while (thread.isAlive() && waiting.size() < left);
    } catch (InterruptedException hurried) {
      Thread.currentThread().interrupt();
    }
    synchronized (counts) {
      lost += waiting.stream().filter(line -> line != END).count();
    }
    try {
      socket.close();
    } catch (IOException nothingToSave) {
      // it has gone
    }
    thread.interrupt();
  }
}
