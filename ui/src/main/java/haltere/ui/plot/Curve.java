package haltere.ui.plot;

import java.util.Arrays;

/**
 * A number over time in bounded memory: the newest samples, and minima and maxima of 16, 256 and
 * 4,096 older ones. At 1 kHz, 4 MB hold a minute of samples and 18 hours in all.
 *
 * <p>Where two samples are much further apart than those before, the curve has a gap. A time that
 * goes back means that the recording is played anew: the curve starts again.
 */
public final class Curve {
  /** Takes the parts of a curve that fall into a window, oldest first. */
  public interface Painter {
    /**
     * Draws a sample, or a summary of several: first and last time, minimum and maximum, and
     * whether a line connects it to the previous one.
     */
    void stretch(long fromUs, long toUs, double lowest, double highest, boolean joined);
  }

  private static final int SAMPLES = 1 << 16;
  private static final int STRETCHES = 1 << 14;
  private static final int MERGED = 16;
  private static final int LEVELS = 4;
  private static final int FINEST_PER_COLUMN = 64;
  private static final long MIN_GAP_US = 200_000;
  private static final double GAP_INTERVALS = 30;

  private final String key;
  private final int number;
  private final int field;
  private final SummaryRing[] levels = new SummaryRing[LEVELS];

  /**
   * Number of summaries of the finer level in the last one of each level, 0 if the next starts
   * another.
   */
  private final int[] merged = new int[LEVELS];

  private long firstUs = Long.MIN_VALUE;
  private long lastUs = Long.MIN_VALUE;
  private double last = Double.NaN;
  private double intervalUs;

  /** An empty curve, with its key and the number of its colour. */
  public Curve(String key, int number) {
    this(key, number, 0);
  }

  /** A curve of one of the fields of a lane, by their order. */
  Curve(String key, int number, int field) {
    this.key = key;
    this.number = number;
    this.field = field;
    for (int level = 0; level < LEVELS; level++) {
      levels[level] = new SummaryRing(level == 0 ? SAMPLES : STRETCHES);
    }
  }

  /** Key that identifies the curve; may be empty. */
  public String key() {
    return key;
  }

  /** Number of its colour: 0, 1, 2 …, unique within its lane. */
  public int number() {
    return number;
  }

  /** Index of its field in its lane. */
  public int field() {
    return field;
  }

  /** Time of the newest sample, microseconds; {@link Long#MIN_VALUE} before the first. */
  public long lastUs() {
    return lastUs;
  }

  /**
   * End of the initial transient of an estimate, microseconds: the first tenth of the curve, which
   * does not affect the range of a plot.
   */
  public long settledUs() {
    return firstUs + (lastUs - firstUs) / 10;
  }

  /** The newest value, NaN before the first. */
  public double last() {
    return last;
  }

  /** Takes a sample at a time in microseconds; one that is not a number is left out. */
  public void add(long timeUs, double value) {
    if (Double.isNaN(value) || Double.isInfinite(value)) {
      return;
    }
    if (timeUs < lastUs) {
      removeFrom(timeUs);
    }
    if (lastUs == Long.MIN_VALUE) {
      firstUs = timeUs;
    } else {
      double interval = (double) timeUs - lastUs;
      intervalUs =
          intervalUs == 0 ? interval : intervalUs + 0.05 * (Math.min(interval, 1e6) - intervalUs);
    }
    lastUs = timeUs;
    last = value;
    levels[0].add(timeUs, timeUs, value, value);
    boolean begins = true;
    for (int level = 1; level < LEVELS; level++) {
      begins = merge(level, begins, timeUs, timeUs, value, value);
    }
  }

  /** Merges into the last summary of a level, or starts another one; true if it merged. */
  private boolean merge(
      int level, boolean counts, long fromUs, long toUs, double lowest, double highest) {
    boolean begins = counts && merged[level] == 0;
    if (begins) {
      levels[level].add(fromUs, toUs, lowest, highest);
    } else {
      levels[level].extend(toUs, lowest, highest);
    }
    merged[level] = counts ? (merged[level] + 1) % MERGED : merged[level];
    return begins;
  }

  /** Removes samples from a time in microseconds on, after playback went back. */
  void removeFrom(long timeUs) {
    if (lastUs < timeUs) {
      return;
    }
    for (SummaryRing ring : levels) {
      ring.truncate(timeUs);
    }
    SummaryRing finest = levels[0];
    if (finest.size() == 0) {
      clear();
      return;
    }
    lastUs = finest.toUs(finest.size() - 1);
    last = finest.max(finest.size() - 1);
    for (int level = 1; level < LEVELS; level++) {
      rebuildLevel(level);
    }
  }

  /** Rebuilds the last summary of a level from the finer level. */
  private void rebuildLevel(int level) {
    SummaryRing finer = levels[level - 1];
    SummaryRing ring = levels[level];
    merged[level] = 0;
    int from = ring.size() == 0 ? 0 : finer.firstEndingFrom(ring.toUs(ring.size() - 1) + 1);
    // at most one interval's worth, unless a ring has dropped its oldest
    for (int i = Math.max(from, finer.size() - MERGED); i < finer.size(); i++) {
      merge(level, true, finer.fromUs(i), finer.toUs(i), finer.min(i), finer.max(i));
    }
  }

  /** Removes all samples. */
  public void clear() {
    for (int level = 0; level < LEVELS; level++) {
      levels[level].clear();
      merged[level] = 0;
    }
    lastUs = Long.MIN_VALUE;
    last = Double.NaN;
    intervalUs = 0;
  }

  /**
   * Draws a window with a number of pixel columns: at most some dozens of summaries for each. One
   * more on either side connects lines to the edges.
   */
  public void paint(long fromUs, long toUs, int columns, Painter painter) {
    int level = level(fromUs, toUs, columns);
    SummaryRing ring = levels[level];
    double gapUs = gapUs();
    long beforeUs = Long.MIN_VALUE;
    for (int i = Math.max(0, ring.firstEndingFrom(fromUs) - 1); i < ring.size(); i++) {
      boolean joined = beforeUs != Long.MIN_VALUE && ring.fromUs(i) - beforeUs <= gapUs;
      painter.stretch(ring.fromUs(i), ring.toUs(i), ring.min(i), ring.max(i), joined);
      beforeUs = ring.toUs(i);
      if (beforeUs > toUs) {
        return;
      }
    }
  }

  private double gapUs() {
    return Math.max(MIN_GAP_US, GAP_INTERVALS * intervalUs);
  }

  /** The finest level that reaches back far enough and is not far too fine. */
  private int level(long fromUs, long toUs, int columns) {
    for (int level = 0; level < LEVELS - 1; level++) {
      SummaryRing ring = levels[level];
      boolean reachesBack =
          ring.size() == 0
              || ring.fromUs(0) <= fromUs
              || ring.fromUs(0) <= levels[level + 1].fromUs(0);
      int within = ring.firstEndingFrom(toUs) - ring.firstEndingFrom(fromUs);
      if (reachesBack && within <= FINEST_PER_COLUMN * Math.max(1, columns)) {
        return level;
      }
    }
    return LEVELS - 1;
  }

  /**
   * The value at a time in microseconds: that of the nearest sample, or the middle of its summary;
   * NaN without a sample nearby.
   */
  public double valueAt(long timeUs) {
    for (SummaryRing ring : levels) {
      if (ring.size() > 0 && (ring.fromUs(0) <= timeUs || ring == levels[LEVELS - 1])) {
        int after = Math.min(ring.size() - 1, ring.firstEndingFrom(timeUs));
        int nearest =
            after > 0 && timeUs - ring.toUs(after - 1) < Math.abs(ring.fromUs(after) - timeUs)
                ? after - 1
                : after;
        long away =
            Math.max(0, Math.max(ring.fromUs(nearest) - timeUs, timeUs - ring.toUs(nearest)));
        return away <= gapUs() ? (ring.min(nearest) + ring.max(nearest)) / 2 : Double.NaN;
      }
    }
    return Double.NaN;
  }

  /** Memory that the samples take, bytes. */
  public long bytes() {
    return Arrays.stream(levels).mapToLong(SummaryRing::bytes).sum();
  }
}
