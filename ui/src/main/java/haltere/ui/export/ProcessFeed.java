package haltere.ui.export;

import java.io.IOException;
import java.io.OutputStream;
import java.time.Duration;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Hands blocks of bytes to a process on a thread of its own, so that a process that takes nothing
 * keeps nobody from giving up.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ProcessFeed {
  private static final byte[] END = {};

  private final OutputStream pipe;
  private final Duration patience;
  private final ArrayBlockingQueue<byte[]> waiting = new ArrayBlockingQueue<>(2);
  private final Thread thread = new Thread(this::feed, "haltere-film");
  private volatile IOException problem;

  /**
   * Begins.
   *
   * @param process its standard input is this one's from now on
   * @param patience how long it may take nothing
   */
  ProcessFeed(Process process, Duration patience) {
    pipe = process.getOutputStream();
    this.patience = patience;
    thread.setDaemon(true);
    thread.start();
  }

  private void feed() {
    try {
      byte[] block = waiting.take();
      while (block != END) {
        write(block);
        block = waiting.take();
      }
      pipe.close();
    } catch (InterruptedException given) {
      Thread.currentThread().interrupt();
    } catch (IOException broken) {
      problem = broken;
    }
  }

  /** What comes after a broken pipe is left out: who hands it over hears of that. */
  private void write(byte[] block) {
    try {
      if (problem == null) {
        pipe.write(block);
      }
    } catch (IOException broken) {
      problem = broken;
    }
  }

  /**
   * Hands a block over.
   *
   * @param block the feed's from now on
   * @return false if the process has not taken what it got before for too long
   * @throws IOException if the process takes no more
   */
  boolean hand(byte[] block) throws IOException, InterruptedException {
    if (problem != null) {
      throw problem;
    }
    return waiting.offer(block, patience.toMillis(), TimeUnit.MILLISECONDS);
  }

  /**
   * Closes the pipe once all has been taken.
   *
   * @return false if the process has not taken what it got before for too long
   */
  boolean end() throws IOException, InterruptedException {
    return hand(END);
  }

  /** Gives up; the process has been ended. */
  void stop() {
    thread.interrupt();
  }
}
