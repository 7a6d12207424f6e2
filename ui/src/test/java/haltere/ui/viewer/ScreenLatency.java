package haltere.ui.viewer;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * How long it takes from the moment when events are handed to the chain until JavaFX's thread has
 * put the picture that they are on into the window, for the newest events of each picture. What the
 * renderer needs to draw the window comes on top, at most one frame.
 *
 * <p>Thread rule: {@link #packet} on the processing thread, the rest on JavaFX's.
 */
final class ScreenLatency implements StreamHandler {
  private static final int KEPT = 1 << 16;

  private final AtomicLongArray timesUs = new AtomicLongArray(KEPT);
  private final AtomicLongArray nanos = new AtomicLongArray(KEPT);
  private final double[] millis;
  private volatile long packets;
  private int count;

  /**
   * A measurement.
   *
   * @param capacity pictures beyond this are not measured
   */
  ScreenLatency(int capacity) {
    millis = new double[capacity];
  }

  @Override
  public void packet(EventPacket packet) {
    int slot = (int) (packets % KEPT);
    timesUs.set(slot, packet.lastTimeUs());
    nanos.set(slot, System.nanoTime());
    packets++;
  }

  @Override
  public void notified(StreamNotification notification) {}

  /** A picture of the events until a time is in the window now. */
  void shown(long timeUs) {
    long now = System.nanoTime();
    long newest = packets - 1;
    for (long i = newest; i >= 0 && i > newest - KEPT / 2; i--) {
      int slot = (int) (i % KEPT);
      if (timesUs.get(slot) < timeUs) {
        if (count < millis.length) {
          millis[count++] = (now - nanos.get(slot)) / 1e6;
        }
        return;
      }
    }
  }

  /** Forgets what was measured. */
  void clear() {
    count = 0;
  }

  /** One for each picture. */
  double[] millis() {
    return Arrays.copyOf(millis, count);
  }
}
