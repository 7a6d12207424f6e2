package haltere.core.playback;

import haltere.core.event.EventPacket;

/**
 * Counts the events of the last microsecond that were passed on. A slice by count may start between
 * events of equal time.
 *
 * <p>Thread rule: the processing thread only.
 */
final class EventTies {
  private long positionUs = Long.MIN_VALUE;
  private int count;

  /** Forgets the count; the next events do not follow the last ones. */
  void forget() {
    positionUs = Long.MIN_VALUE;
  }

  /** Counts events that are passed on; called before the chain changes them. */
  void handOver(EventPacket piece, long offsetUs) {
    int size = piece.size();
    long lastUs = piece.timeUs(size - 1);
    int ties = 0;
    while (ties < size && piece.timeUs(size - 1 - ties) == lastUs) {
      ties++;
    }
    long lastPositionUs = lastUs + offsetUs;
    count = ties == size && lastPositionUs == positionUs ? count + ties : ties;
    positionUs = lastPositionUs;
  }

  /** Number of events with exactly this elapsed time that were passed on. */
  int at(long elapsedUs) {
    return elapsedUs == positionUs ? count : 0;
  }
}
