package haltere.testing.evaluation;

import java.util.Locale;

/**
 * The speeds with which vehicles were counted at lines, against their own: what somebody reads who
 * counts traffic. Thread rule: that of its owner.
 */
final class CrossingSpeeds {
  /** 95 % of the squares of a normal number are below. */
  private static final double CHI_SQUARE_1 = 3.841;

  /** Of slower ones, a share of the speed says nothing. */
  private static final double LEAST_KM_H = 10.8;

  private final Spread ratios = new Spread();
  private final Share within = new Share();

  /** Takes a vehicle that was counted. */
  void add(double speedKmH, double sdKmH, double trueKmH) {
    if (trueKmH >= LEAST_KM_H) {
      double error = speedKmH - trueKmH;
      ratios.add(speedKmH / trueKmH);
      within.add(error * error / (sdKmH * sdKmH), CHI_SQUARE_1);
    }
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "speed at counting lines: bias %.2f %%, standard deviation %.1f %% (%d), within their 95 %%"
            + " %.1f %% (by chance +-%.1f)%n",
        100 * (ratios.mean() - 1),
        100 * ratios.sd(),
        ratios.count(),
        100 * within.within(),
        100 * within.chance());
  }
}
