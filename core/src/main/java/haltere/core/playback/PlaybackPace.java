package haltere.core.playback;

/**
 * When slices are due, and how late they come: the clock, the measured speed and the lag.
 *
 * <p>Places are on the elapsed timeline, in microseconds. Thread rule: the processing thread only.
 */
final class PlaybackPace {
  /** Playback that is later than this does not catch up: the clock waits for the chain. */
  private static final long MAX_CATCH_UP_NANOS = 1_000_000_000L;

  private final PlaybackClock clock;
  private final PlaybackMeter meter;
  private long slipNanos;
  private long lagNanos;

  PlaybackPace(PlaybackClock clock, PlaybackMeter meter) {
    this.clock = clock;
    this.meter = meter;
  }

  PlaybackMeter meter() {
    return meter;
  }

  /** The speed that was asked for. */
  double speed() {
    return clock.speed();
  }

  /** Plays at another speed from a place on; at unlimited speed the clock stood still. */
  void setSpeed(double speed, long place) {
    if (clock.unlimited()) {
      clock.setPosition(place);
    }
    clock.setSpeed(speed);
    forgetLag();
  }

  /** Lets time go on towards a place, which is due now if the clock has passed it. */
  void resume(long place, boolean dueNow) {
    if (dueNow || clock.positionUs() > place) {
      clock.setPosition(place);
    }
    clock.resume();
    forgetLag();
  }

  /** Holds time. */
  void hold() {
    clock.pause();
    meter.restart();
  }

  /** A place elsewhere is due now. */
  void jumpTo(long place) {
    clock.setPosition(place);
    forgetLag();
  }

  /** The place that is played is another from now on, as when a loop starts again. */
  void shift(long us) {
    clock.shift(us);
    meter.shift(us);
  }

  /** Nanoseconds until a place is due, negative if it is overdue. */
  long nanosUntil(long place) {
    return clock.nanosUntil(place);
  }

  /** A slice begins for which the clock was not asked. */
  void stepBegins(long place) {
    clock.setPosition(place);
  }

  /** A slice begins that was due before so many nanoseconds. */
  void sliceBegins(long place, long lateNanos) {
    if (!clock.unlimited()) {
      long slip = Math.max(0, lateNanos - MAX_CATCH_UP_NANOS);
      clock.delay(slip);
      slipNanos += slip;
      lagNanos = slipNanos + lateNanos - slip;
    }
    meter.sliceBegins(clock.nanoTime(), place);
  }

  /** Real time by which playback is late, microseconds; 0 at unlimited speed. */
  long lagUs() {
    return clock.unlimited() ? 0 : lagNanos / 1000;
  }

  private void forgetLag() {
    slipNanos = 0;
    lagNanos = 0;
    meter.restart();
  }
}
