package haltere.filters.wing.stroke;

/** What a filter forgets: what events do not show returns to what is likely of flies. */
final class StrokeMemory {
  private static final double FORGET_S = 1;
  private static final double RATE_S = 0.2;
  private static final double[] SERIES_SD = {0.08, 0.03, 0.012};
  private static final double WIDTH_MEAN = 0.025;
  private static final double WIDTH_SD = 0.02;
  private static final double LAG_MEAN_S = 50e-6;
  private static final double LAG_SD_S = 150e-6;

  private StrokeMemory() {}

  /**
   * Forgets.
   *
   * @param filter of the wing
   * @param dtS since the last time
   * @param rateSd of the rate at which the frequency changes
   */
  static void forget(StrokeEkf filter, double dtS, double rateSd) {
    filter.belief.decay(StrokeEkf.RATE, 0, 1 - Math.exp(-dtS / RATE_S), rateSd);
    double share = 1 - Math.exp(-dtS / FORGET_S);
    filter.belief.decay(StrokeEkf.WIDTH, WIDTH_MEAN, share, WIDTH_SD);
    filter.belief.decay(StrokeEkf.LAG, LAG_MEAN_S, share, LAG_SD_S);
    for (int i = StrokeEkf.SERIES; i < filter.size; i++) {
      filter.belief.decay(i, 0, share, SERIES_SD[(i - StrokeEkf.SERIES) / 2]);
    }
  }
}
