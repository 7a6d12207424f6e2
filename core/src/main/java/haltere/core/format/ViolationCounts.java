package haltere.core.format;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Counts violations by kind, with the offset of the first of each kind.
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
   * Sets the offset up to which a recording has been read. Violations before it are not counted
   * again after a seek.
   *
   * @param offset byte offset in the file
   */
  public void reached(long offset) {
    reached = Math.max(reached, offset);
  }

  /**
   * Offset up to which the recording has been read.
   *
   * @return byte offset in the file; violations before it are not counted again
   */
  public long reached() {
    return reached;
  }

  /**
   * Counts a violation of a kind that occurs at most once in a recording.
   *
   * @param kind the kind
   * @param offset byte offset in the file
   */
  public void addOnce(Violation kind, long offset) {
    if (count(kind) == 0) {
      add(kind, Math.max(offset, reached));
    }
  }

  /**
   * Counts a violation.
   *
   * @param kind the kind
   * @param offset byte offset in the file
   */
  public void add(Violation kind, long offset) {
    add(kind, offset, 1);
  }

  /**
   * Counts several violations of a kind.
   *
   * @param kind the kind
   * @param offset byte offset of the first of them; before {@link #reached} they are not counted
   * @param count their number, at least 0
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
   * Copies the count of a kind from other counts.
   *
   * @param kind the kind
   * @param other the source
   */
  public void take(Violation kind, ViolationCounts other) {
    counts[kind.ordinal()] = other.counts[kind.ordinal()];
    firstOffsets[kind.ordinal()] = other.firstOffsets[kind.ordinal()];
  }

  /**
   * Number of violations of a kind.
   *
   * @param kind the kind
   * @return at least 0
   */
  public long count(Violation kind) {
    return counts[kind.ordinal()];
  }

  /**
   * Offset of the first violation of a kind.
   *
   * @param kind the kind
   * @return byte offset, or -1 if there is none
   */
  public long firstOffset(Violation kind) {
    return counts[kind.ordinal()] == 0 ? -1 : firstOffsets[kind.ordinal()];
  }

  /** Resets all counts. */
  public void clear() {
    java.util.Arrays.fill(counts, 0);
    reached = 0;
  }

  /**
   * A line for each kind with violations.
   *
   * @return for users
   */
  public List<String> describe() {
    return describe(EnumSet.noneOf(Violation.class));
  }

  /**
   * A line for each kind with violations.
   *
   * @param reported kinds to omit because they are reported otherwise
   * @return for users
   */
  public List<String> describe(Set<Violation> reported) {
    List<String> lines = new ArrayList<>();
    for (Violation kind : KINDS) {
      if (count(kind) > 0 && !reported.contains(kind)) {
        lines.add(
            kind == Violation.CUT_OFF
                ? kind.description() + " (byte " + firstOffset(kind) + ")"
                : String.format(
                    Locale.ROOT,
                    "%,d %s (first at byte %d)",
                    count(kind),
                    kind.description(count(kind)),
                    firstOffset(kind)));
      }
    }
    return lines;
  }
}
