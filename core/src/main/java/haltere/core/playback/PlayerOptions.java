package haltere.core.playback;

import java.util.Objects;
import java.util.function.LongSupplier;

/**
 * Options at the start of a player.
 *
 * @param slicing how the stream is cut
 * @param speed recording time per real time, {@link PlaybackClock#MIN_SPEED} to infinity
 * @param loop whether it starts again at its end
 * @param paused whether it shows its first slice and waits
 * @param nanoTime the clock, nanoseconds
 * @param sleeper how to wait for it; used by one player only
 * @since 0.1
 */
public record PlayerOptions(
    Slicing slicing,
    double speed,
    Loop loop,
    boolean paused,
    LongSupplier nanoTime,
    Sleeper sleeper) {
  /** Checks that nothing is missing and the speed is possible. */
  public PlayerOptions {
    Objects.requireNonNull(slicing, "slicing");
    Objects.requireNonNull(loop, "loop");
    Objects.requireNonNull(nanoTime, "nanoTime");
    Objects.requireNonNull(sleeper, "sleeper");
    PlaybackClock.checkSpeed(speed);
  }

  /**
   * Real time, sixty pictures a second, once, at once.
   *
   * @return new options with a sleeper of their own
   */
  public static PlayerOptions defaults() {
    return new PlayerOptions(
        new Slicing.PerFrame(60), 1, Loop.OFF, false, System::nanoTime, Sleeper.real());
  }

  /**
   * The same with another slicing.
   *
   * @param other how the stream is cut
   * @return new options
   */
  public PlayerOptions withSlicing(Slicing other) {
    return new PlayerOptions(other, speed, loop, paused, nanoTime, sleeper);
  }

  /**
   * The same at another speed.
   *
   * @param other recording time per real time
   * @return new options
   */
  public PlayerOptions withSpeed(double other) {
    return new PlayerOptions(slicing, other, loop, paused, nanoTime, sleeper);
  }

  /**
   * The same with another loop.
   *
   * @param other whether it starts again at its end
   * @return new options
   */
  public PlayerOptions withLoop(Loop other) {
    return new PlayerOptions(slicing, speed, other, paused, nanoTime, sleeper);
  }

  /**
   * The same, waiting at the first slice or not.
   *
   * @param other whether it waits
   * @return new options
   */
  public PlayerOptions withPaused(boolean other) {
    return new PlayerOptions(slicing, speed, loop, other, nanoTime, sleeper);
  }

  /**
   * The same over another clock.
   *
   * @param otherNanoTime the clock, nanoseconds
   * @param otherSleeper how to wait for it
   * @return new options
   */
  public PlayerOptions withClock(LongSupplier otherNanoTime, Sleeper otherSleeper) {
    return new PlayerOptions(slicing, speed, loop, paused, otherNanoTime, otherSleeper);
  }
}
