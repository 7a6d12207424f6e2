package haltere.ui.plot;

import java.util.concurrent.atomic.AtomicLong;

/**
 * A bounded queue of samples between two threads, without locks or allocation. Neither side waits;
 * samples that do not fit are counted and dropped.
 *
 * <p>Thread rule: one thread puts samples in, one takes them out; {@link #lost} is for any.
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

  private final long[] timesUs;
  private final String[] keys;
  private final double[] values;

  /** Number of samples written; the position of the next is this modulo length. */
  private final AtomicLong written = new AtomicLong();

  /** Number of samples read. */
  private final AtomicLong taken = new AtomicLong();

  private final AtomicLong lost = new AtomicLong();

  /** An empty queue with a capacity in samples. */
  public SampleQueue(int capacity) {
    timesUs = new long[capacity];
    keys = new String[capacity];
    values = new double[capacity];
  }

  /** Puts a sample in, or counts it as lost. */
  public void put(long timeUs, String key, double value) {
    long number = written.getPlain();
    if (number - taken.getAcquire() == timesUs.length) {
      lost.incrementAndGet();
      return;
    }
    int place = (int) (number % timesUs.length);
    timesUs[place] = timeUs;
    keys[place] = key;
    values[place] = value;
    written.setRelease(number + 1);
  }

  /** Takes out all that is there, oldest first. */
  public void drainTo(SampleConsumer consumer) {
    long end = written.getAcquire();
    for (long number = taken.getPlain(); number < end; number++) {
      int place = (int) (number % timesUs.length);
      consumer.take(timesUs[place], keys[place], values[place]);
      keys[place] = null;
      taken.setRelease(number + 1);
    }
  }

  /** How many samples did not fit. */
  public long lost() {
    return lost.get();
  }
}
