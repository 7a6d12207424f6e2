package haltere.core.format;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Counts violations by kind and remembers where each kind was first seen.
 *
 * <p>Thread rule: one thread.
 *
 * @since 0.1
 */
public final class ViolationCounts {
  private static final Violation[] KINDS = Violation.values();

  private final long[] counts = new long[KINDS.length];
  private final long[] firstOffsets = new long[KINDS.length];
  private long reached;

  /**
   * States how far a recording has been read. What lies before that is not counted again when a
   * reader goes back.
   *
   * @param offset byte offset in the file
   */
  public void reached(long offset) {
    reached = Math.max(reached, offset);
  }

  /**
   * How far the recording has been read.
   *
   * @return byte offset in the file; what lies before it is not counted any more
   */
  public long reached() {
    return reached;
  }

  /**
   * Counts one of a kind that there is once in a recording at most.
   *
   * @param kind what was wrong
   * @param offset byte offset in the file
   */
  public void addOnce(Violation kind, long offset) {
    if (count(kind) == 0) {
      add(kind, Math.max(offset, reached));
    }
  }

  /**
   * Counts one.
   *
   * @param kind what was wrong
   * @param offset byte offset in the file
   */
  public void add(Violation kind, long offset) {
    add(kind, offset, 1);
  }

  /**
   * Counts several of a kind.
   *
   * @param kind what was wrong
   * @param offset byte offset of the first of them; before {@link #reached} they are not counted
   * @param count how many, at least 0
   */
  public void add(Violation kind, long offset, long count) {
    if (count == 0 || offset < reached) {
      return;
    }
    int index = kind.ordinal();
    if (counts[index] == 0) {
      firstOffsets[index] = offset;
    }
    counts[index] += count;
  }

  /**
   * Takes over what another one has counted of a kind.
   *
   * @param kind what was wrong
   * @param other has the count
   */
  public void take(Violation kind, ViolationCounts other) {
    counts[kind.ordinal()] = other.counts[kind.ordinal()];
    firstOffsets[kind.ordinal()] = other.firstOffsets[kind.ordinal()];
  }

  /**
   * How often a kind was seen.
   *
   * @param kind what was wrong
   * @return at least 0
   */
  public long count(Violation kind) {
    return counts[kind.ordinal()];
  }

  /**
   * Where a kind was first seen.
   *
   * @param kind what was wrong
   * @return byte offset, or -1 if it was never seen
   */
  public long firstOffset(Violation kind) {
    return counts[kind.ordinal()] == 0 ? -1 : firstOffsets[kind.ordinal()];
  }

  /** Forgets all counts. */
  public void clear() {
    java.util.Arrays.fill(counts, 0);
    reached = 0;
  }

  /**
   * A line per kind that was seen.
   *
   * @return for users
   */
  public List<String> describe() {
    return describe(EnumSet.noneOf(Violation.class));
  }

  /**
   * A line per kind that was seen.
   *
   * @param told kinds that have been told otherwise and are left out
   * @return for users
   */
  public List<String> describe(Set<Violation> told) {
    List<String> lines = new ArrayList<>();
    for (Violation kind : KINDS) {
      if (count(kind) > 0 && !told.contains(kind)) {
        lines.add(
            kind == Violation.CUT_OFF
                ? kind.sentence() + " (byte " + firstOffset(kind) + ")"
                : String.format(
                    Locale.ROOT,
                    "%,d %s (first at byte %d)",
                    count(kind),
                    kind.sentence(),
                    firstOffset(kind)));
      }
    }
    return lines;
  }
}
