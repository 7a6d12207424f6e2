package haltere.ui.viewer.picture;

import java.util.OptionalInt;

/**
 * Counts events before and after a chain: those of a slice that is held, so that a moment has one
 * number however it was reached, else those of playback since the last number. Counted on the
 * processing thread; {@link #takePercentHidden} is for any.
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

  /** What was counted since the last slice is not shown. */
  void discard() {
    before = 0;
    after = 0;
  }

  synchronized void hold() {
    isHeld = true;
  }

  /** Percentage that the chain removed, 0 of a held slice without events; empty if too few came. */
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
