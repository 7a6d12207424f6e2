package haltere.ui.plot;

import java.util.Arrays;

/**
 * A number over time in bounded memory: the newest samples as they are, older ones as the lowest
 * and highest of each 16, 256 and 4,096 of them. At 1 kHz that is a minute of samples, and 18 hours
 * in all, in at most 4 MB.
 *
 * <p>Where two samples are much further apart than those before, the curve has a gap. A time that
 * goes back means that the recording is played anew: the curve starts again.
 */
public final class Curve {
  /** Takes the parts of a curve that fall into a window, oldest first. */
  public interface Painter {
    /**
     * Takes a sample, or several that are too many to be told apart: first and last time, lowest
     * and highest value, and whether a line leads to it from the stretch before.
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
   * Stretches of the finer level in the last one of each level, 0 where the next begins another.
   */
  private final int[] merged = new int[LEVELS];

  private long firstUs = Long.MIN_VALUE;
  private long lastUs = Long.MIN_VALUE;
  private double last = Double.NaN;
  private double intervalUs;

  /**
   * An empty curve, with a key that tells it from others and the number that gives it its colour.
   */
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

  /** What tells the curve from others, in words; may be empty. */
  public String key() {
    return key;
  }

  /** What gives it its colour: 0, 1, 2 …, another for each curve of its lane. */
  public int number() {
    return number;
  }

  /** How many fields stand before its own in its lane. */
  public int field() {
    return field;
  }

  /** Time of the newest sample, microseconds; {@link Long#MIN_VALUE} before the first. */
  public long lastUs() {
    return lastUs;
  }

  /**
   * End of the transient with which an estimate begins, microseconds: the first tenth of the curve,
   * which does not matter to the range of a plot.
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
      forgetFrom(timeUs);
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

  /** Merges into the last stretch of a level, or begins another one; true if it did. */
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

  /**
   * Playback went back to a time in microseconds: what lies before it stays, the rest comes anew.
   */
  void forgetFrom(long timeUs) {
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
    last = finest.highest(finest.size() - 1);
    for (int level = 1; level < LEVELS; level++) {
      mergeAnew(level);
    }
  }

  /** Begins the last stretch of a level with what the finer one has behind the last. */
  private void mergeAnew(int level) {
    SummaryRing finer = levels[level - 1];
    SummaryRing ring = levels[level];
    merged[level] = 0;
    int from = ring.size() == 0 ? 0 : finer.firstEndingFrom(ring.toUs(ring.size() - 1) + 1);
    // at most as many as make a stretch, but where a ring has forgotten its oldest
    for (int i = Math.max(from, finer.size() - MERGED); i < finer.size(); i++) {
      merge(level, true, finer.fromUs(i), finer.toUs(i), finer.lowest(i), finer.highest(i));
    }
  }

  /** Forgets all samples. */
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
   * Hands over what falls into a window of so many columns of pixels: some dozens of stretches at
   * most for each. One stretch on either side comes along, so that lines lead to the edges.
   */
  public void paint(long fromUs, long toUs, int columns, Painter painter) {
    int level = level(fromUs, toUs, columns);
    SummaryRing ring = levels[level];
    double gapUs = gapUs();
    long beforeUs = Long.MIN_VALUE;
    for (int i = Math.max(0, ring.firstEndingFrom(fromUs) - 1); i < ring.size(); i++) {
      boolean joined = beforeUs != Long.MIN_VALUE && ring.fromUs(i) - beforeUs <= gapUs;
      painter.stretch(ring.fromUs(i), ring.toUs(i), ring.lowest(i), ring.highest(i), joined);
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
   * The value at a time in microseconds: that of the nearest sample, or the middle of the stretch
   * it lies in; NaN where the curve has nothing near.
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
        return away <= gapUs() ? (ring.lowest(nearest) + ring.highest(nearest)) / 2 : Double.NaN;
      }
    }
    return Double.NaN;
  }

  /** Memory that the samples take, bytes. */
  public long bytes() {
    return Arrays.stream(levels).mapToLong(SummaryRing::bytes).sum();
  }
}
