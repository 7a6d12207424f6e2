package haltere.core.playback;

import java.util.Objects;
import java.util.function.LongSupplier;

/**
 * Maps real time to a position that moves at a speed, stands still or jumps. Due times are computed
 * from the last change, never added up, so they do not drift.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public final class PlaybackClock {
  /** The slowest speed: one ten-thousandth of real time. */
  public static final double MIN_SPEED = 1e-4;

  private final LongSupplier nanoTime;
  private final Sleeper sleeper;
  private double speed = 1;
  private boolean running;
  private long anchorNanos;
  private double anchorUs;

  /**
   * A clock that stands at position 0.
   *
   * @param nanoTime real time, nanoseconds from anywhere
   * @param sleeper how to wait for it
   */
  public PlaybackClock(LongSupplier nanoTime, Sleeper sleeper) {
    this.nanoTime = Objects.requireNonNull(nanoTime, "nanoTime");
    this.sleeper = Objects.requireNonNull(sleeper, "sleeper");
    anchorNanos = nanoTime.getAsLong();
  }

  /**
   * Checks a speed.
   *
   * @param speed recording time per real time
   * @throws IllegalArgumentException below {@link #MIN_SPEED}
   */
  public static void checkSpeed(double speed) {
    if (!(speed >= MIN_SPEED)) {
      throw new IllegalArgumentException(
          "speed must be " + MIN_SPEED + " or more, or infinite, not " + speed);
    }
  }

  /**
   * The speed.
   *
   * @return recording time per real time, infinite for as fast as possible
   */
  public double speed() {
    return speed;
  }

  /**
   * Whether speed has no limit.
   *
   * @return true if every position is due at once
   */
  public boolean unlimited() {
    return Double.isInfinite(speed);
  }

  /**
   * Whether the position moves.
   *
   * @return false while paused
   */
  public boolean running() {
    return running;
  }

  /**
   * Changes the speed from now on.
   *
   * @param newSpeed {@link #MIN_SPEED} to infinity
   */
  public void setSpeed(double newSpeed) {
    checkSpeed(newSpeed);
    anchorHere();
    speed = newSpeed;
  }

  /** Lets the position move. */
  public void resume() {
    anchorHere();
    running = true;
  }

  /** Holds the position. */
  public void pause() {
    anchorHere();
    running = false;
  }

  /**
   * Jumps: the position is due now.
   *
   * @param positionUs new position, microseconds
   */
  public void setPosition(long positionUs) {
    anchorNanos = nanoTime.getAsLong();
    anchorUs = positionUs;
  }

  /**
   * Adds to all positions, as when a loop goes from its end to its start.
   *
   * @param us microseconds to add to every position
   */
  public void shift(long us) {
    anchorUs += us;
  }

  /**
   * Delays all due times.
   *
   * @param nanos real time
   */
  public void delay(long nanos) {
    anchorNanos += nanos;
  }

  /**
   * The position now.
   *
   * @return microseconds; at unlimited speed where it was last set
   */
  public double positionUs() {
    return running && !unlimited()
        ? anchorUs + (nanoTime.getAsLong() - anchorNanos) * speed / 1000
        : anchorUs;
  }

  /**
   * Time until a position is due.
   *
   * @param positionUs microseconds
   * @return nanoseconds of real time, negative if it is overdue, 0 at unlimited speed, {@link
   *     Long#MAX_VALUE} while paused
   */
  public long nanosUntil(long positionUs) {
    if (!running) {
      return Long.MAX_VALUE;
    }
    if (unlimited()) {
      return 0;
    }
    double fromAnchor = (positionUs - anchorUs) * 1000 / speed;
    return (long) (fromAnchor - (nanoTime.getAsLong() - anchorNanos));
  }

  /**
   * Real time.
   *
   * @return nanoseconds from anywhere
   */
  public long nanoTime() {
    return nanoTime.getAsLong();
  }

  /**
   * Waits until a time has passed or the sleeper is woken.
   *
   * @param nanos real time, {@link Long#MAX_VALUE} for until woken
   * @throws InterruptedException if the thread is interrupted
   */
  public void sleep(long nanos) throws InterruptedException {
    sleeper.sleep(nanos);
  }

  private void anchorHere() {
    anchorUs = positionUs();
    anchorNanos = nanoTime.getAsLong();
  }

  @Override
  public String toString() {
    return positionUs() + " us at speed " + speed + (running ? "" : ", paused");
  }
}
