package haltere.ui.rendering;

import haltere.core.event.EventPacket;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;

/**
 * The newest events, for a picture of them in space and time.
 *
 * <p>Thread rule: one thread at a time, in the viewer the processing thread.
 */
public final class SpaceTimeCloud implements StreamHandler {
  /** A copy of the newest events, from the oldest to the newest. */
  public static final class Points {
    final int[] addresses;
    final int[] agesUs;
    int count;

    /**
     * No points.
     *
     * @param capacity how many there may be
     */
    public Points(int capacity) {
      addresses = new int[capacity];
      agesUs = new int[capacity];
    }

    /**
     * How many there are.
     *
     * @return 0 to the capacity
     */
    public int count() {
      return count;
    }
  }

  private final long[] times;
  private final int[] addresses;
  private long taken;
  private long nowUs;

  /**
   * A cloud without events.
   *
   * @param capacity how many of the newest events are kept
   */
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
      int place = (int) (taken++ % times.length);
      times[place] = newTimes[i];
      addresses[place] = newAddresses[i];
    }
    if (size > 0) {
      nowUs = newTimes[size - 1];
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.endsContinuity() && !(notification instanceof DataLost)) {
      taken = 0;
    }
  }

  /**
   * Lets time go on without events.
   *
   * @param timeUs time on the source's clock
   */
  public void advanceTo(long timeUs) {
    nowUs = Math.max(nowUs, timeUs);
  }

  /**
   * Copies the events of the last while.
   *
   * @param spanUs how far back, at most {@link Integer#MAX_VALUE}
   * @param points receives them; the newest ones if there are more than it can hold
   */
  public void copyTo(long spanUs, Points points) {
    int kept = (int) Math.min(taken, times.length);
    int first = Math.max(0, kept - points.addresses.length);
    int count = 0;
    for (int i = first; i < kept; i++) {
      int place = (int) ((taken - kept + i) % times.length);
      long ageUs = nowUs - times[place];
      if (ageUs <= spanUs) {
        points.addresses[count] = addresses[place];
        points.agesUs[count++] = (int) ageUs;
      }
    }
    points.count = count;
  }
}
