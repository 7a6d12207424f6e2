package haltere.core.playback;

import haltere.core.event.EventPacket;

/**
 * The elapsed timeline of a source without end: starts at the source's first event, and where the
 * source's clock restarts it continues 1 us behind the last event.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ElapsedTimeline {
  private boolean offsetKnown;
  private long offsetUs;
  private long endUs;

  /** Starts again at 0 with what comes next. */
  void begin() {
    offsetKnown = false;
    endUs = 0;
  }

  /** The source's clock restarts with what comes next. */
  void clockRestarts() {
    offsetKnown = false;
  }

  /** The next events of the source. */
  void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    if (!offsetKnown) {
      offsetUs = endUs - packet.firstTimeUs();
      offsetKnown = true;
    }
    endUs = packet.lastTimeUs() + offsetUs + 1;
  }

  /** Elapsed time of a time on the source's clock, in the stretch of the last packet. */
  long elapsedUs(long timeUs) {
    return timeUs + offsetUs;
  }
}
