package haltere.core.stream;

import haltere.core.stream.internal.Daemon;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Independent pieces of a filter's work, done by the processing thread alone or together with a
 * second thread. The pieces are the same in both cases, so that results are identical; a filter
 * publishes between pieces only.
 *
 * <p>A thread takes the next piece when it has done one. The first thread does what the second has
 * not begun, so that it never waits for a thread that does not run. The second thread spins for a
 * while before it sleeps. Nothing is allocated.
 *
 * <p>Thread rule: {@link #each} and {@link #close} are for the processing thread.
 *
 * @since 0.1
 */
public final class SharedWork implements AutoCloseable {
  /** Work on the processing thread alone. */
  public static final SharedWork ALONE = new SharedWork(1);

  /** Time for which a thread spins before it sleeps: that of some wake-ups. */
  private static final long SPIN_NANOS = 50_000;

  private final AtomicInteger left = new AtomicInteger();
  private final AtomicInteger undone = new AtomicInteger();
  private final boolean isShared;
  private Thread second;
  private int count;
  private IntConsumer work;
  private Throwable failure;
  private volatile Thread first;
  private volatile boolean sleeps;
  private volatile boolean waits;
  private volatile boolean ended;

  /**
   * Work for some threads.
   *
   * @param threads 1 for the processing thread alone; 2 for another one, which starts with the
   *     first work that has two pieces, and ends when this is closed
   */
  public SharedWork(int threads) {
    if (threads < 1 || threads > 2) {
      throw new IllegalArgumentException(threads + " threads, it must be 1 or 2");
    }
    isShared = threads == 2;
  }

  /**
   * Does all pieces and returns when they are done. An exception of a piece is thrown here, when no
   * piece runs any more; others may have been done or not.
   *
   * @param pieces their number
   * @param piece does the piece of an index from 0; long ones come first
   */
  public void each(int pieces, IntConsumer piece) {
    if (!isShared || ended || pieces < 2) {
      for (int i = 0; i < pieces; i++) {
        piece.accept(i);
      }
      return;
    }
    if (second == null) {
      second = Daemon.thread(this::help, "haltere-filter");
      second.start();
    }
    first = Thread.currentThread();
    work = piece;
    count = pieces;
    undone.set(pieces);
    left.set(pieces);
    if (sleeps) {
      LockSupport.unpark(second);
    }
    while (takeOne()) {
      // until all are taken
    }
    awaitDone();
    work = null;
    if (failure != null) {
      throwFailure();
    }
  }

  private boolean takeOne() {
    int now = left.get();
    if (now <= 0) {
      return false;
    }
    if (left.compareAndSet(now, now - 1)) {
      try {
        work.accept(count - now);
      } catch (RuntimeException | Error thrown) {
        fail(thrown);
      }
      if (undone.decrementAndGet() == 0 && waits) {
        LockSupport.unpark(first);
      }
    }
    return true;
  }

  private synchronized void fail(Throwable thrown) {
    failure = failure == null ? thrown : failure;
  }

  private void throwFailure() {
    Throwable thrown = failure;
    failure = null;
    if (thrown instanceof Error error) {
      throw error;
    }
    throw (RuntimeException) thrown;
  }

  private void awaitDone() {
    long sinceNanos = System.nanoTime();
    while (undone.get() > 0) {
      if (System.nanoTime() - sinceNanos < SPIN_NANOS) {
        Thread.onSpinWait();
      } else {
        waits = true;
        if (undone.get() > 0) {
          LockSupport.park(this);
        }
        waits = false;
      }
    }
  }

  private void help() {
    long sinceNanos = System.nanoTime();
    while (!ended) {
      if (takeOne()) {
        sinceNanos = System.nanoTime();
      } else if (System.nanoTime() - sinceNanos < SPIN_NANOS) {
        Thread.onSpinWait();
      } else {
        sleeps = true;
        if (left.get() <= 0 && !ended) {
          LockSupport.park(this);
        }
        sleeps = false;
        sinceNanos = System.nanoTime();
      }
    }
  }

  /** Ends the second thread; later work is done on the processing thread. */
  @Override
  public void close() {
    ended = true;
    LockSupport.unpark(second);
  }
}
