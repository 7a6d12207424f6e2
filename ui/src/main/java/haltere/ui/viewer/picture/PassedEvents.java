package haltere.ui.viewer.picture;

import java.util.OptionalInt;

/**
 * Counts events before and after a chain, of a held slice, or else of playback since the last
 * query. Counts on the processing thread; {@link #takePercentHidden} may be called from any.
 */
final class PassedEvents {
  /** Events that playback needs at least for a number. */
  private static final long MIN_EVENTS = 200;

  long before;
  long after;
  private long lastBefore;
  private long lastAfter;
  private long playedBefore;
  private long playedAfter;
  private boolean isHeld;

  synchronized void endSlice() {
    lastBefore = before;
    lastAfter = after;
    playedBefore += before;
    playedAfter += after;
    isHeld = false;
    discard();
  }

  /** Discards events counted since the last slice. */
  void discard() {
    before = 0;
    after = 0;
  }

  synchronized void hold() {
    isHeld = true;
  }

  /**
   * Percentage that the chain removed, 0 of a held slice without events; empty for too few events.
   */
  synchronized OptionalInt takePercentHidden() {
    long in = isHeld ? lastBefore : playedBefore;
    long out = isHeld ? lastAfter : playedAfter;
    if (!isHeld && in < MIN_EVENTS) {
      return OptionalInt.empty();
    }
    playedBefore = 0;
    playedAfter = 0;
    return OptionalInt.of((int) Math.round(100.0 * Math.max(0, in - out) / Math.max(1, in)));
  }
}
