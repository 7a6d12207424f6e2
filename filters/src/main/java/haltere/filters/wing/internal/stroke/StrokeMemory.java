package haltere.filters.wing.internal.stroke;

/**
 * Return of unobserved parameters to usual values of flies: an Ornstein-Uhlenbeck process with a
 * process noise density of 2 sd²/τ.
 */
final class StrokeMemory {
  private static final double FORGET_S = 1;
  private static final double RATE_S = 0.2;
  private static final double[] SERIES_SD = {0.08, 0.03, 0.012};
  private static final double WIDTH_MEAN = 0.025;
  private static final double WIDTH_SD = 0.02;
  private static final double LAG_MEAN_S = 50e-6;
  private static final double LAG_SD_S = 150e-6;

  private StrokeMemory() {}

  /** Sets the densities of these entries. */
  static void setDensities(double[] q, double rateSd) {
    q[StrokeEkf.RATE] = 2 * rateSd * rateSd / RATE_S;
    q[StrokeEkf.WIDTH] = 2 * WIDTH_SD * WIDTH_SD / FORGET_S;
    q[StrokeEkf.LAG] = 2 * LAG_SD_S * LAG_SD_S / FORGET_S;
    for (int i = StrokeEkf.SERIES; i < q.length; i++) {
      double sd = SERIES_SD[(i - StrokeEkf.SERIES) / 2];
      q[i] = 2 * sd * sd / FORGET_S;
    }
  }

  /** Decays the entries. Without events of both edges, width and lag are held, without variance. */
  static void forget(StrokeEkf filter, double dtS, double[] q, boolean both) {
    double share = 1 - Math.exp(-dtS / FORGET_S);
    decay(filter, StrokeEkf.RATE, 0, 1 - Math.exp(-dtS / RATE_S), q[StrokeEkf.RATE] * RATE_S);
    if (both) {
      decay(filter, StrokeEkf.WIDTH, WIDTH_MEAN, share, q[StrokeEkf.WIDTH] * FORGET_S);
      decay(filter, StrokeEkf.LAG, LAG_MEAN_S, share, q[StrokeEkf.LAG] * FORGET_S);
    } else {
      filter.belief.scale(StrokeEkf.WIDTH, 0);
      filter.belief.scale(StrokeEkf.LAG, 0);
    }
    for (int i = StrokeEkf.SERIES; i < filter.size; i++) {
      decay(filter, i, 0, share, q[i] * FORGET_S);
    }
  }

  private static void decay(
      StrokeEkf filter, int entry, double towards, double share, double twiceVariance) {
    filter.belief.decay(entry, towards, share, Math.sqrt(twiceVariance / 2));
  }
}
