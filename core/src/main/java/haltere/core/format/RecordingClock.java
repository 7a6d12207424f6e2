package haltere.core.format;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * The clock of a recording's times. Readers return all times as 64-bit microseconds; wraps of a
 * narrower clock are undone.
 *
 * <p>Thread rule: immutable.
 *
 * @param zero what times count from
 * @param turnUs after how many microseconds the clock in the file starts again from zero; empty if
 *     it is wide enough not to. A silence of more than a turn cannot be distinguished from a short
 *     one, unless the format has words of time in between
 * @since 0.1
 */
public record RecordingClock(Zero zero, OptionalLong turnUs) {
  /** What times count from. */
  public enum Zero {
    /** The camera's start, or the last reset of its clock. */
    CAMERA_START("the camera's start or its clock's last reset"),
    /** The start of the recording. */
    RECORDING_START("the recording's start"),
    /** Midnight (UTC) before the first of January 1970. */
    YEAR_1970("1970"),
    /** Whatever the program that wrote the file meant: the format does not say. */
    WRITERS_CHOICE("chosen by the writing program");

    private final String words;

    Zero(String words) {
      this.words = words;
    }
  }

  /** Checks. */
  public RecordingClock {
    Objects.requireNonNull(zero, "zero");
    if (turnUs.isPresent() && turnUs.getAsLong() <= 0) {
      throw new IllegalArgumentException("a turn takes longer than " + turnUs.getAsLong() + " us");
    }
  }

  /**
   * A clock that does not turn.
   *
   * @param zero what times count from
   * @return the facts
   */
  public static RecordingClock wide(Zero zero) {
    return new RecordingClock(zero, OptionalLong.empty());
  }

  /**
   * A clock that turns.
   *
   * @param zero what times count from
   * @param turnUs length of a turn in microseconds, above 0
   * @return the facts
   */
  public static RecordingClock turning(Zero zero, long turnUs) {
    return new RecordingClock(zero, OptionalLong.of(turnUs));
  }

  /**
   * What is zero, for a user.
   *
   * @return a line such as {@code 1970}
   */
  public String describe() {
    return turnUs.isEmpty()
        ? zero.words
        : zero.words + "; wraps of " + turnUs.getAsLong() / 1e6 + " s are undone";
  }
}
