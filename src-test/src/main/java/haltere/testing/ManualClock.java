package haltere.testing;

import haltere.core.playback.Sleeper;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * Virtual time: a clock that moves only when told, and a sleeper for which a wait is over at once,
 * with the clock so much later. A wait without end is a real one, until woken.
 */
public final class ManualClock implements LongSupplier, Sleeper {
  private final AtomicLong nanos = new AtomicLong();
  private final Semaphore woken = new Semaphore(0);

  /** A clock at 0. */
  public ManualClock() {}

  /**
   * Lets time pass.
   *
   * @param passed nanoseconds
   */
  public void advance(long passed) {
    nanos.addAndGet(passed);
  }

  @Override
  public long getAsLong() {
    return nanos.get();
  }

  @Override
  public void sleep(long wanted) throws InterruptedException {
    if (wanted == Long.MAX_VALUE) {
      woken.acquire();
      woken.drainPermits();
    } else {
      advance(wanted);
    }
  }

  @Override
  public void wake() {
    woken.release();
  }
}
