package haltere.ui.rendering;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;

/**
 * The newest events for a picture in space and time.
 *
 * <p>Thread rule: one thread at a time, in the viewer the processing thread.
 */
public final class SpaceTimeCloud implements StreamHandler {
  /** A copy of the newest events, from the oldest to the newest. */
  public static final class Points {
    final int[] addresses;
    final int[] agesUs;
    int count;

    /** No points, with a capacity. */
    public Points(int capacity) {
      addresses = new int[capacity];
      agesUs = new int[capacity];
    }

    /** Number of points. */
    public int count() {
      return count;
    }
  }

  private final long[] times;
  private final int[] addresses;
  private long taken;
  private long nowUs;

  /** An empty cloud, with a capacity for the newest events. */
  public SpaceTimeCloud(int capacity) {
    times = new long[capacity];
    addresses = new int[capacity];
  }

  @Override
  public void packet(EventPacket packet) {
    int size = packet.size();
    long[] newTimes = packet.timesUs();
    int[] newAddresses = packet.addresses();
    for (int i = Math.max(0, size - times.length); i < size; i++) {
      int position = (int) (taken++ % times.length);
      times[position] = newTimes[i];
      addresses[position] = newAddresses[i];
    }
    if (size > 0) {
      nowUs = newTimes[size - 1];
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.restartsTime()) {
      taken = 0;
    }
  }

  /** Lets time go on without events. */
  public void advanceTo(long timeUs) {
    nowUs = Math.max(nowUs, timeUs);
  }

  /**
   * Copies the events of a time span, at most {@link Integer#MAX_VALUE} us; the newest ones if
   * there are more than the points can hold.
   */
  public void copyTo(long spanUs, Points points) {
    int kept = (int) Math.min(taken, times.length);
    int first = Math.max(0, kept - points.addresses.length);
    int count = 0;
    for (int i = first; i < kept; i++) {
      int position = (int) ((taken - kept + i) % times.length);
      long ageUs = nowUs - times[position];
      if (ageUs <= spanUs) {
        points.addresses[count] = addresses[position];
        points.agesUs[count++] = (int) ageUs;
      }
    }
    points.count = count;
  }
}
