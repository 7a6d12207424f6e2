package haltere.core.format;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * The clock of a recording's times. Readers return all times as 64-bit microseconds; wraps of a
 * narrower clock are undone.
 *
 * <p>Thread rule: immutable.
 *
 * @param zero origin of the times
 * @param wrapPeriodUs period after which the clock in the file wraps to zero, in microseconds;
 *     empty if it does not wrap. A gap of more than one period cannot be distinguished from a
 *     shorter one, unless the format has time words in between
 * @since 0.1
 */
public record RecordingClock(Zero zero, OptionalLong wrapPeriodUs) {
  /** Origin of the times. */
  public enum Zero {
    /** The camera's start, or the last reset of its clock. */
    CAMERA_START("the camera's start or its clock's last reset"),
    /** The start of the recording. */
    RECORDING_START("the recording's start"),
    /** The first of January 1970, 00:00 UTC. */
    YEAR_1970("1970"),
    /** Chosen by the program that wrote the file; the format does not define it. */
    WRITERS_CHOICE("chosen by the writing program");

    private final String words;

    Zero(String words) {
      this.words = words;
    }
  }

  /** Checks the values. */
  public RecordingClock {
    Objects.requireNonNull(zero, "zero");
    if (wrapPeriodUs.isPresent() && wrapPeriodUs.getAsLong() <= 0) {
      throw new IllegalArgumentException(
          "the wrap period is above 0 us, not " + wrapPeriodUs.getAsLong());
    }
  }

  /**
   * A clock that does not wrap.
   *
   * @param zero origin of the times
   * @return the clock
   */
  public static RecordingClock continuous(Zero zero) {
    return new RecordingClock(zero, OptionalLong.empty());
  }

  /**
   * A clock that wraps.
   *
   * @param zero origin of the times
   * @param wrapPeriodUs wrap period in microseconds, above 0
   * @return the clock
   */
  public static RecordingClock wrapping(Zero zero, long wrapPeriodUs) {
    return new RecordingClock(zero, OptionalLong.of(wrapPeriodUs));
  }

  /**
   * The origin, for users.
   *
   * @return a line such as {@code 1970}
   */
  public String describe() {
    return wrapPeriodUs.isEmpty()
        ? zero.words
        : zero.words + "; wraps of " + wrapPeriodUs.getAsLong() / 1e6 + " s are undone";
  }
}
