package haltere.core.format.internal.clock;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamNotification;

/**
 * The order of the events of a segment. Programs that merge the packets of a camera write events
 * slightly out of order. A late event gets the newest time, so that times ascend; a clock that goes
 * back by more starts a new segment.
 *
 * <p>Thread rule: one thread.
 */
public final class EventOrder {
  /**
   * Largest step back that is no restart of the clock, microseconds: cameras send a partly filled
   * USB packet after 1 ms.
   */
  public static final long MAX_LATE_US = 1000;

  private long newestUs = StreamNotification.NO_TIME_US;

  /** The order before the first event of a segment. */
  public EventOrder() {}

  /**
   * Whether a step back is within the disorder of a segment.
   *
   * @param newestUs time before it, microseconds
   * @param timeUs time after it, microseconds
   * @return false if it is a restart of the clock, or without a time before it
   */
  public static boolean isLate(long newestUs, long timeUs) {
    return timeUs < newestUs && timeUs >= newestUs - MAX_LATE_US;
  }

  /**
   * Whether an event is late.
   *
   * @param timeUs its time, before that of the event before it, microseconds
   * @return false if the clock was restarted
   */
  public boolean isLate(long timeUs) {
    return isLate(newestUs, timeUs);
  }

  /**
   * Raises late events to the newest time before them.
   *
   * @param packet the next events of the segment; their times ascend from an index on
   * @param from the index
   */
  public void raise(EventPacket packet, int from) {
    if (from == packet.size()) {
      return;
    }
    long[] timesUs = packet.timesUs();
    for (int i = from; i < packet.size() && timesUs[i] < newestUs; i++) {
      timesUs[i] = newestUs;
    }
    newestUs = packet.lastTimeUs();
  }

  /**
   * Time of the newest event.
   *
   * @return microseconds, or {@link StreamNotification#NO_TIME_US} before the first of a segment
   */
  public long newestUs() {
    return newestUs;
  }

  /**
   * Continues at another position.
   *
   * @param timeUs time of the newest event before it, or {@link StreamNotification#NO_TIME_US} at
   *     the start of a segment
   */
  public void continueAfter(long timeUs) {
    newestUs = timeUs;
  }
}
