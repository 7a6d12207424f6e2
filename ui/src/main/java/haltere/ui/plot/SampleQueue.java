package haltere.ui.plot;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Carries samples from one thread to another through a ring of fixed size. Neither side waits; what
 * does not fit is counted and left out.
 *
 * <p>Thread rule: one thread puts, one drains; the count may be read from any thread.
 */
public final class SampleQueue {
  /** Takes samples. */
  public interface SampleConsumer {
    /**
     * Takes a sample: time on the recording's clock in microseconds, which curve, and the number,
     * which may be NaN.
     */
    void take(long timeUs, String key, double value);
  }

  private final long[] times;
  private final double[] values;
  private final String[] keys;
  private final int mask;
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong read = new AtomicLong();
  private final AtomicLong lost = new AtomicLong();

  /** An empty queue for so many samples, a power of two. */
  public SampleQueue(int capacity) {
    if (capacity < 2 || Integer.bitCount(capacity) != 1) {
      throw new IllegalArgumentException("capacity " + capacity + " is no power of two");
    }
    times = new long[capacity];
    values = new double[capacity];
    keys = new String[capacity];
    mask = capacity - 1;
  }

  /** Puts a sample in, or counts it as lost. */
  public void put(long timeUs, String key, double value) {
    long at = written.getPlain();
    if (at - read.get() > mask) {
      lost.lazySet(lost.getPlain() + 1);
      return;
    }
    int slot = (int) at & mask;
    times[slot] = timeUs;
    keys[slot] = key;
    values[slot] = value;
    written.set(at + 1);
  }

  /** Takes out all that is there, oldest first. */
  public void drainTo(SampleConsumer consumer) {
    long end = written.get();
    for (long at = read.getPlain(); at < end; at++) {
      int slot = (int) at & mask;
      consumer.take(times[slot], keys[slot], values[slot]);
    }
    read.set(end);
  }

  /** How many samples did not fit. */
  public long lost() {
    return lost.get();
  }
}
