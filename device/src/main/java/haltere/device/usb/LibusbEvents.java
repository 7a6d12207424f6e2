package haltere.device.usb;

import haltere.core.stream.internal.Daemon;
import java.nio.IntBuffer;
import java.util.concurrent.TimeUnit;
import org.usb4java.Context;
import org.usb4java.LibUsb;

/**
 * Calls the listeners of ended transfers while a device is open: on the threads of waiting
 * consumers, and on its own thread while they are busy. libusb allows one of them at a time; the
 * others wait for its results.
 *
 * <p>Thread rule: all methods may be called from any thread that is not within a listener.
 */
final class LibusbEvents implements BusWork {
  private static final long MAX_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

  /** Time without a call after which a consumer is busy. */
  private static final long BUSY_MS = 4;

  private static final long BUSY_NANOS = TimeUnit.MILLISECONDS.toNanos(BUSY_MS);

  /** Shortest interval of checks by a busy consumer. */
  private static final long POLL_NANOS = TimeUnit.MICROSECONDS.toNanos(250);

  private final Context context;
  private int users;
  private int pauses;
  private int consumers;
  private long consumedNanos = System.nanoTime() - BUSY_NANOS;
  private boolean threadWorks;
  private Thread thread;

  LibusbEvents(Context context) {
    this.context = context;
  }

  /** Enables event handling until {@link #leave}. */
  synchronized void join() {
    users++;
    if (thread == null) {
      thread = Daemon.thread(this::run, "haltere-usb");
      thread.start();
    }
  }

  /** Ends one {@link #join}. */
  void leave() {
    synchronized (this) {
      users--;
      notifyAll();
    }
    interrupt();
  }

  @Override
  public void interrupt() {
    LibUsb.interruptEventHandler(context);
  }

  // ---- On the thread of its own

  private void run() {
    while (mayGoOn()) {
      handleFor(MAX_NANOS, null);
    }
  }

  private synchronized boolean mayGoOn() {
    threadWorks = false;
    long ms = untilConsumersAreBusyMs();
    while ((pauses > 0 || (users > 0 && ms > 0)) && await(Math.max(1, ms))) {
      ms = untilConsumersAreBusyMs();
    }
    if (users > 0) {
      threadWorks = true;
      return true;
    }
    thread = null;
    return false;
  }

  /** Shortest time until all consumers are busy; 0 if they are, or if there is none. */
  private long untilConsumersAreBusyMs() {
    if (consumers > 0) {
      return BUSY_MS;
    }
    long left = BUSY_NANOS - (System.nanoTime() - consumedNanos);
    return left > 0 ? TimeUnit.NANOSECONDS.toMillis(left) + 1 : 0;
  }

  /** Waits; false if the thread was interrupted. The caller holds the monitor. */
  private boolean await(long ms) {
    try {
      wait(ms);
      return true;
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  private void handleFor(long nanos, IntBuffer noMore) {
    LibUsb.handleEventsTimeoutCompleted(context, TimeUnit.NANOSECONDS.toMicros(nanos), noMore);
  }

  // ---- On a consumer's thread

  @Override
  public boolean doFor(long nanos, IntBuffer noMore) {
    boolean takeOver;
    synchronized (this) {
      if (nanos <= 0
          && (threadWorks || pauses > 0 || System.nanoTime() - consumedNanos < POLL_NANOS)) {
        return true;
      }
      if (pauses > 0) {
        await(1);
        return true;
      }
      consumers++;
      takeOver = threadWorks;
    }
    if (takeOver) {
      interrupt();
    }
    try {
      handleFor(Math.min(nanos, MAX_NANOS), noMore);
    } finally {
      synchronized (this) {
        consumers--;
        consumedNanos = System.nanoTime();
      }
    }
    return true;
  }

  // ---- On any

  /**
   * Runs an action while no thread is in a listener or returning from one: usb4java still accesses
   * the transfer after its listener has returned.
   */
  void betweenEvents(Runnable action) {
    synchronized (this) {
      pauses++;
    }
    interrupt();
    LibUsb.lockEvents(context);
    try {
      action.run();
    } finally {
      LibUsb.unlockEvents(context);
      synchronized (this) {
        pauses--;
        notifyAll();
      }
    }
  }
}
