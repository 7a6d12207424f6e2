package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.device.usb.UsbBus;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * Times at which a lost camera is searched: at once when a device is plugged in, if the bus reports
 * it; often for some seconds after that, since access may not be granted yet; and rarely otherwise.
 *
 * <p>Thread rule: one thread begins, waits and ends; {@link #close} from any.
 */
final class SearchSchedule implements AutoCloseable {
  /**
   * Intervals of the search.
   *
   * @param oftenNanos without reports of the bus, and after a report
   * @param rarelyNanos before a report of the bus
   */
  record Pace(long oftenNanos, long rarelyNanos) {
    /** Five times a second, or every two seconds. */
    static final Pace DEFAULT =
        new Pace(TimeUnit.MILLISECONDS.toNanos(200), TimeUnit.SECONDS.toNanos(2));
  }

  private static final long GETTING_READY_NANOS = TimeUnit.SECONDS.toNanos(3);

  private final UsbBus bus;
  private final Pace pace;
  private final Semaphore woken = new Semaphore(0);
  private Optional<UsbBus.Watch> watch = Optional.empty();
  private boolean closed;

  // state of the waiting thread
  private long nextNanos;
  private long oftenUntilNanos;

  SearchSchedule(UsbBus bus, Pace pace) {
    this.bus = bus;
    this.pace = pace;
  }

  /** Starts the search: the first attempt is now. */
  void begin() {
    synchronized (this) {
      if (!closed) {
        watch = watch();
      }
    }
    nextNanos = System.nanoTime();
    oftenUntilNanos = nextNanos + GETTING_READY_NANOS;
  }

  private Optional<UsbBus.Watch> watch() {
    try {
      return bus.watch(woken::release);
    } catch (CameraProblem ignored) {
      return Optional.empty();
    }
  }

  /**
   * Waits until the next attempt is due, or this is closed.
   *
   * @param nanos longest wait
   * @return false after the longest wait
   */
  boolean await(long nanos) throws InterruptedException {
    long wait = nextNanos - System.nanoTime();
    if (woken.tryAcquire(Math.max(0, Math.min(nanos, wait)), TimeUnit.NANOSECONDS)) {
      woken.drainPermits();
      oftenUntilNanos = System.nanoTime() + GETTING_READY_NANOS;
    } else if (nanos < wait) {
      return false;
    }
    long now = System.nanoTime();
    boolean often = now - oftenUntilNanos < 0 || !isNotified();
    nextNanos = now + (often ? pace.oftenNanos : pace.rarelyNanos);
    return true;
  }

  private synchronized boolean isNotified() {
    return watch.isPresent();
  }

  /** Ends the search after the camera was found. */
  synchronized void end() {
    watch.ifPresent(UsbBus.Watch::close);
    watch = Optional.empty();
  }

  /** Ends the search for good; waiting threads wake up. */
  @Override
  public synchronized void close() {
    closed = true;
    end();
    woken.release();
  }
}
