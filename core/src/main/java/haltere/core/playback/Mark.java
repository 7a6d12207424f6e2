package haltere.core.playback;

import java.util.Comparator;
import java.util.Objects;

/**
 * A named position in a recording.
 *
 * @param name for users
 * @param elapsedUs elapsed time, microseconds, at least 0
 * @since 0.1
 */
public record Mark(String name, long elapsedUs) implements Comparable<Mark> {
  /** Checks that there is a name. */
  public Mark {
    Objects.requireNonNull(name, "name");
    if (elapsedUs < 0) {
      throw new IllegalArgumentException("a mark cannot stand at " + elapsedUs + " us");
    }
  }

  @Override
  public int compareTo(Mark other) {
    return Comparator.comparingLong(Mark::elapsedUs).thenComparing(Mark::name).compare(this, other);
  }
}
