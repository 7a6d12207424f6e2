package haltere.ui.plot;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Carries samples from one thread to another, at most so many at once. Neither side waits for room
 * or for samples; what does not fit is counted and left out.
 *
 * <p>Thread rule: all methods may be called from any thread.
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

  private record Sample(long timeUs, String key, double value) {}

  private final ArrayBlockingQueue<Sample> samples;
  private final AtomicLong lost = new AtomicLong();

  /** An empty queue for so many samples. */
  public SampleQueue(int capacity) {
    samples = new ArrayBlockingQueue<>(capacity);
  }

  /** Puts a sample in, or counts it as lost. */
  public void put(long timeUs, String key, double value) {
    if (!samples.offer(new Sample(timeUs, key, value))) {
      lost.incrementAndGet();
    }
  }

  /** Takes out all that is there, oldest first. */
  public void drainTo(SampleConsumer consumer) {
    for (int left = samples.size(); left > 0; left--) {
      Sample sample = samples.poll();
      consumer.take(sample.timeUs, sample.key, sample.value);
    }
  }

  /** How many samples did not fit. */
  public long lost() {
    return lost.get();
  }
}
