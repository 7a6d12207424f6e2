package haltere.testing;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Assertions;

/** Waits for what other threads do, and not for ever. */
public final class Waiting {
  private static final long LIMIT_NANOS = TimeUnit.SECONDS.toNanos(60);
  private static final long PERIOD_NANOS = TimeUnit.MICROSECONDS.toNanos(200);

  private Waiting() {}

  /**
   * Comes back once a condition holds; fails after a minute, or where the thread is interrupted.
   */
  public static void until(String what, BooleanSupplier condition) {
    long startNanos = System.nanoTime();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() - startNanos > LIMIT_NANOS || Thread.currentThread().isInterrupted()) {
        Assertions.fail("waited in vain for: " + what);
      }
      LockSupport.parkNanos(PERIOD_NANOS);
    }
  }
}
