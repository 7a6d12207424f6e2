package haltere.core.sink;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Passes the latest value from one thread to another: a new value replaces one that was not taken.
 * Neither side waits.
 *
 * <p>Thread rule: one thread puts, another takes; the counts may be read from any thread.
 *
 * @param <T> type of the values, immutable or no longer used by the producer
 * @since 0.1
 */
public final class Mailbox<T> {
  private final AtomicReference<T> latest = new AtomicReference<>();
  private final AtomicLong put = new AtomicLong();
  private final AtomicLong conflated = new AtomicLong();

  /** An empty mailbox. */
  public Mailbox() {}

  /**
   * Puts a value.
   *
   * @param value the latest
   * @return the replaced value, which was never taken and can be reused, or null
   */
  public T put(T value) {
    Objects.requireNonNull(value, "value");
    T replaced = latest.getAndSet(value);
    put.lazySet(put.getPlain() + 1);
    if (replaced != null) {
      conflated.lazySet(conflated.getPlain() + 1);
    }
    return replaced;
  }

  /**
   * Takes the latest value.
   *
   * @return the value, or null if none came since the last call
   */
  public T poll() {
    return latest.get() == null ? null : latest.getAndSet(null);
  }

  /**
   * Values that were put.
   *
   * @return a count
   */
  public long puts() {
    return put.get();
  }

  /**
   * Values that were replaced before anyone took them.
   *
   * @return a count
   */
  public long conflated() {
    return conflated.get();
  }
}
