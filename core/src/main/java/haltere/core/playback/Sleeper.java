package haltere.core.playback;

import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * Lets a processing thread wait for its clock. Tests use one that moves a manual clock.
 *
 * <p>Thread rule: {@link #sleep} on one thread, {@link #wake} from any.
 *
 * @since 0.1
 */
public interface Sleeper {
  /**
   * Waits until {@link #wake} is called; not at all if it was called since the last wait ended.
   *
   * @param nanos maximum time, {@link Long#MAX_VALUE} for no limit
   * @throws InterruptedException if the thread is interrupted
   */
  void sleep(long nanos) throws InterruptedException;

  /** Ends the present wait, or the next one if nobody waits. */
  void wake();

  /**
   * Waits in real time.
   *
   * @return a new sleeper
   */
  static Sleeper real() {
    Semaphore woken = new Semaphore(0);
    return new Sleeper() {
      @Override
      public void sleep(long nanos) throws InterruptedException {
        if (nanos == Long.MAX_VALUE) {
          woken.acquire();
        } else if (!woken.tryAcquire(nanos, TimeUnit.NANOSECONDS)) {
          return;
        }
        woken.drainPermits();
      }

      @Override
      public void wake() {
        woken.release();
      }
    };
  }
}
