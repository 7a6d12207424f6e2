package haltere.core.playback;

/**
 * Due times of slices and the lag behind them.
 *
 * <p>Positions are on the elapsed timeline, in microseconds. Thread rule: the processing thread
 * only.
 */
final class PlaybackPace {
  /** Maximum lag that is caught up; the clock waits for the chain beyond it. */
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

  /** Requested speed. */
  double speed() {
    return clock.speed();
  }

  /** Changes the speed from a position on; at unlimited speed the clock had stopped. */
  void setSpeed(double speed, long positionUs) {
    if (clock.unlimited()) {
      clock.setPosition(positionUs);
    }
    clock.setSpeed(speed);
    resetLag();
  }

  /** Resumes the clock before a position, which is due now if the clock has passed it. */
  void resume(long positionUs, boolean dueNow) {
    if (dueNow || clock.positionUs() > positionUs) {
      clock.setPosition(positionUs);
    }
    clock.resume();
    resetLag();
  }

  /** Stops the clock. */
  void hold() {
    clock.pause();
    meter.restart();
  }

  /** Moves to a position, which is due now. */
  void jumpTo(long positionUs) {
    clock.setPosition(positionUs);
    resetLag();
  }

  /** Adds to all positions, as when a loop starts again. */
  void shift(long us) {
    clock.shift(us);
    meter.shift(us);
  }

  /** Nanoseconds until a position is due, negative if it is overdue. */
  long nanosUntil(long positionUs) {
    return clock.nanosUntil(positionUs);
  }

  /** A slice begins independently of the clock. */
  void stepBegins(long positionUs) {
    clock.setPosition(positionUs);
  }

  /** A slice begins, some nanoseconds after it was due. */
  void sliceBegins(long positionUs, long lateNanos) {
    if (!clock.unlimited()) {
      long slip = Math.max(0, lateNanos - MAX_CATCH_UP_NANOS);
      clock.delay(slip);
      slipNanos += slip;
      lagNanos = slipNanos + lateNanos - slip;
    }
    meter.sliceBegins(clock.nanoTime(), positionUs);
  }

  /** Lag in real time, microseconds; 0 at unlimited speed. */
  long lagUs() {
    return clock.unlimited() ? 0 : lagNanos / 1000;
  }

  private void resetLag() {
    slipNanos = 0;
    lagNanos = 0;
    meter.restart();
  }
}
