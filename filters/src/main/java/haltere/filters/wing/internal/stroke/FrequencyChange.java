package haltere.filters.wing.internal.stroke;

/**
 * How much more than usual the frequency has changed within some milliseconds, against what its
 * rate of change let expect. A frequency that begins to change faster than the filter is ready for
 * is followed late, so that it is then off by about as much as it has changed: that is seen sooner
 * than the phases run away ({@link RunAway}).
 *
 * <p>A fly's wings are driven as one: the mean change of both counts. Thread rule: one thread at a
 * time.
 */
final class FrequencyChange {
  /** Looks, of about a millisecond, over which a change counts. */
  private static final int LOOKS = 6;

  /** A square so many times the usual one is no more than usual. */
  private static final double USUAL_TIMES = 2;

  /** Mean square, as a share of what the filter thinks of its frequency, before any was seen. */
  private static final double FIRST_SHARE = 0.2;

  private static final double FIRST_WEIGHT = 30;
  private static final double MAX_WEIGHT = 400;

  private double change;
  private double usual;
  private double weight;

  /** Square of the change beyond what is usual, squared radians a squared second. */
  double excess;

  /**
   * Looks, about once in a millisecond; in calm flight, the change counts as usual. The other wing
   * is the one that is driven together with this one; null if none is known.
   */
  void look(FrequencyHistory history, boolean calm, FrequencyChange other) {
    if (weight == 0) {
      usual = FIRST_SHARE * history.variance[history.ago(0)];
      weight = FIRST_WEIGHT;
    }
    change = history.change(LOOKS);
    double mean = other == null ? change : (change + other.change) / 2;
    double clearly = USUAL_TIMES * usual;
    excess = Math.max(0, mean * mean - clearly);
    if (calm && change != 0) {
      weight = Math.min(MAX_WEIGHT, weight + 1);
      usual += (Math.min(mean * mean, clearly) - usual) / weight;
    }
  }
}
