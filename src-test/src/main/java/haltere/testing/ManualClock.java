package haltere.testing;

import haltere.core.playback.Sleeper;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * Virtual time: a clock that advances on request only, and a sleeper that advances the clock
 * instead of waiting. A wait without end is real, until woken.
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
