package haltere.device.usb;

import org.usb4java.Context;
import org.usb4java.LibUsb;

/**
 * The thread of the bus: calls the listeners of transfers that have ended, while a device is open.
 *
 * <p>Thread rule: all methods may be called from any thread but its own.
 */
final class LibusbEvents {
  private static final long WAIT_US = 100_000;

  private final Context context;
  private int users;
  private int pauses;
  private Thread thread;

  LibusbEvents(Context context) {
    this.context = context;
  }

  /** Keeps the thread running until {@link #leave}. */
  synchronized void join() {
    users++;
    if (thread == null) {
      thread = new Thread(this::run, "haltere-usb");
      thread.setDaemon(true);
      thread.start();
    }
  }

  /** Takes back one {@link #join}. */
  void leave() {
    synchronized (this) {
      users--;
    }
    LibUsb.interruptEventHandler(context);
  }

  private void run() {
    while (mayGoOn()) {
      LibUsb.handleEventsTimeout(context, WAIT_US);
    }
  }

  private synchronized boolean mayGoOn() {
    while (pauses > 0) {
      try {
        wait();
      } catch (InterruptedException nobodyDoes) {
        Thread.currentThread().interrupt();
        break;
      }
    }
    if (users > 0) {
      return true;
    }
    thread = null;
    return false;
  }

  /**
   * Does something while no thread is within a listener, nor on its way out of one: after a
   * listener has returned, usb4java still looks at the transfer.
   */
  void betweenEvents(Runnable action) {
    synchronized (this) {
      pauses++;
    }
    LibUsb.interruptEventHandler(context);
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
