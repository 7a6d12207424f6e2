package haltere.filters.wing;

/**
 * How sure the frequencies of both wings really are. A fly's wings are driven as one, and two
 * filters measure their frequency from different events: what both differ by is what each is off
 * by, but for what they have in common. The filters themselves think worse of their frequency than
 * it is, because they have to be ready for a manoeuvre. Manoeuvres are left out here; there the
 * filters are right.
 *
 * <p>Thread rule: one thread at a time.
 */
final class FrequencyAgreement {
  /** Variance, as a share of what the filter thinks, before anything was compared. */
  private static final double FIRST_SHARE = 0.15;

  private static final double FIRST_WEIGHT = 10;
  private static final double MOST_WEIGHT = 100;
  private static final double LEAST_SHARE = 0.02;
  private static final double MOST_SHARE = 4;

  /** What both wings are off by together, by the same measure, as found on simulated flies. */
  private static final double COMMON = 0.015;

  private double share = FIRST_SHARE;
  private double weight = FIRST_WEIGHT;

  /** Begins with what is usual. */
  void launch() {
    share = FIRST_SHARE;
    weight = FIRST_WEIGHT;
  }

  /**
   * Compares both wings, about once in ten milliseconds of steady flight.
   *
   * @param difference of the angular frequencies
   * @param variance sum of the variances that the filters think they have
   */
  void compare(double difference, double variance) {
    weight = Math.min(MOST_WEIGHT, weight + 1);
    share += (difference * difference / variance - share) / weight;
    share = Math.max(LEAST_SHARE, Math.min(MOST_SHARE, share));
  }

  /** Variance in steady flight as a share of what a filter thinks. */
  double share() {
    return COMMON + share;
  }
}
