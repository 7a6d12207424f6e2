package haltere.core.playback;

import haltere.core.event.EventPacket;

/**
 * Counts how many events of the last microsecond have been handed over, because a slice of so many
 * events may start in the midst of a microsecond.
 *
 * <p>Thread rule: the processing thread only.
 */
final class EventTies {
  private long place = Long.MIN_VALUE;
  private int count;

  /** What is handed over next does not follow what was. */
  void forget() {
    place = Long.MIN_VALUE;
  }

  /** Events are handed over; to be called before the chain changes them. */
  void handOver(EventPacket piece, long offsetUs) {
    int size = piece.size();
    long lastUs = piece.timeUs(size - 1);
    int ties = 0;
    while (ties < size && piece.timeUs(size - 1 - ties) == lastUs) {
      ties++;
    }
    long lastPlace = lastUs + offsetUs;
    count = ties == size && lastPlace == place ? count + ties : ties;
    place = lastPlace;
  }

  /** Events of exactly this elapsed microsecond that have been handed over. */
  int at(long elapsedUs) {
    return elapsedUs == place ? count : 0;
  }
}
