package haltere.filters.wing;

/**
 * What a filter forgets: what events do not show returns to what is likely of flies.
 *
 * <p>Pixels that are slow, measured by the time that the wing is over them, answer at the reversals
 * alone, and late, by how much depends on how long the wing stays. That looks like a third harmonic
 * together with a larger amplitude, which cancel at the reversals and are off in mid stroke. So the
 * slower the pixels, the less harmonics from the third on are let differ from 0 ({@link
 * #reversalsAlone}).
 */
final class StrokeMemory {
  private static final double FORGET_S = 1;
  private static final double RATE_S = 0.2;
  private static final double[] SERIES_SD = {0.08, 0.03, 0.012};
  private static final double WIDTH_MEAN = 0.025;
  private static final double WIDTH_SD = 0.02;
  private static final double LAG_MEAN_S = 50e-6;
  private static final double LAG_SD_S = 150e-6;

  /** So many times the time over a pixel that ON events lag where half of it holds. */
  private static final double SLOW_LAGS = 9;

  /** Where reversals alone are seen, harmonics from the third on are forgotten so much faster. */
  private static final double SLOW_FORGETTING = 11;

  /** And differ from 0 by such a share of what they do else. */
  private static final double SLOW_SD_SHARE = 0.1;

  private StrokeMemory() {}

  /**
   * How far the pixels show reversals alone.
   *
   * @param lagS of ON behind OFF events, seconds
   * @param overS time for which the wing is over a pixel, seconds
   * @return 0 to 1
   */
  static double reversalsAlone(double lagS, double overS) {
    double lags = Math.max(0, lagS) / (SLOW_LAGS * overS);
    double square = lags * lags;
    double sixth = square * square * square;
    return sixth / (1 + sixth);
  }

  /**
   * Forgets.
   *
   * @param filter of the wing
   * @param dtS since the last time
   * @param rateSd of the rate at which the frequency changes
   * @param slow {@link #reversalsAlone}
   */
  static void forget(StrokeEkf filter, double dtS, double rateSd, double slow) {
    filter.forget(StrokeEkf.RATE, 0, 1 - Math.exp(-dtS / RATE_S), rateSd);
    double share = 1 - Math.exp(-dtS / FORGET_S);
    filter.forget(StrokeEkf.WIDTH, WIDTH_MEAN, share, WIDTH_SD);
    filter.forget(StrokeEkf.LAG, LAG_MEAN_S, share, LAG_SD_S);
    double fast = 1 - Math.exp(-dtS / FORGET_S * (1 + (SLOW_FORGETTING - 1) * slow));
    double less = 1 - (1 - SLOW_SD_SHARE) * slow;
    for (int i = StrokeEkf.SERIES; i < filter.size; i++) {
      boolean second = i < StrokeEkf.SERIES + 2;
      double sd = SERIES_SD[(i - StrokeEkf.SERIES) / 2];
      filter.forget(i, 0, second ? share : fast, second ? sd : less * sd);
    }
  }
}
