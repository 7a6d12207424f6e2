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
  public interface Taker {
    /**
     * Takes a sample.
     *
     * @param timeUs microseconds on the recording's clock
     * @param key which curve
     * @param value the number, may be NaN
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

  /**
   * An empty queue.
   *
   * @param capacity samples it holds, a power of two
   */
  public SampleQueue(int capacity) {
    if (capacity < 2 || Integer.bitCount(capacity) != 1) {
      throw new IllegalArgumentException("capacity " + capacity + " is no power of two");
    }
    times = new long[capacity];
    values = new double[capacity];
    keys = new String[capacity];
    mask = capacity - 1;
  }

  /**
   * Puts a sample in, or counts it as lost.
   *
   * @param timeUs microseconds on the recording's clock
   * @param key which curve
   * @param value the number
   */
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

  /**
   * Takes out all that is there.
   *
   * @param taker called for each sample, oldest first
   */
  public void drainTo(Taker taker) {
    long end = written.get();
    for (long at = read.getPlain(); at < end; at++) {
      int slot = (int) at & mask;
      taker.take(times[slot], keys[slot], values[slot]);
    }
    read.set(end);
  }

  /**
   * Samples that did not fit.
   *
   * @return a count
   */
  public long lost() {
    return lost.get();
  }
}
