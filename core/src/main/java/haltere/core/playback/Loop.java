package haltere.core.playback;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * Whether playback starts again at its end, and between which points. A player that is behind the
 * out point plays on to the end before it goes to the in point.
 *
 * @param on whether playback starts again; if not, the points mean nothing
 * @param inUs elapsed time of the first event of the loop in microseconds, empty for the start
 * @param outUs elapsed time in microseconds that ends the loop and is not played, empty for the end
 * @since 0.1
 */
public record Loop(boolean on, OptionalLong inUs, OptionalLong outUs) {
  /** Plays once. */
  public static final Loop OFF = new Loop(false, OptionalLong.empty(), OptionalLong.empty());

  /** Plays everything again and again. */
  public static final Loop ALL = new Loop(true, OptionalLong.empty(), OptionalLong.empty());

  /** Checks the points. */
  public Loop {
    Objects.requireNonNull(inUs, "inUs");
    Objects.requireNonNull(outUs, "outUs");
    if (inUs.orElse(0) < 0 || outUs.orElse(Long.MAX_VALUE) <= inUs.orElse(0)) {
      throw new IllegalArgumentException(
          "a loop goes from 0 or later to a later point, not from "
              + inUs.orElse(0)
              + " to "
              + outUs.orElse(0)
              + " us");
    }
  }

  /**
   * Plays a part again and again.
   *
   * @param inUs elapsed time of its start, microseconds
   * @param outUs elapsed time of its end, microseconds
   * @return a loop that is on
   */
  public static Loop between(long inUs, long outUs) {
    return new Loop(true, OptionalLong.of(inUs), OptionalLong.of(outUs));
  }
}
