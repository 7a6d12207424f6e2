package haltere.filters.estimation;

import org.apache.commons.statistics.distribution.ChiSquaredDistribution;

/**
 * Whether innovations are white: Bar-Shalom, Li and Kirubarajan (2001), section 5.4,
 * autocorrelation eq. 5.4.2-13.
 */
public final class Whiteness {
  private Whiteness() {}

  /**
   * Autocorrelation of a series of innovations with itself one step later. Near 0 for a consistent
   * filter; of normalised innovations (divided by √S) where S changes.
   *
   * @param innovations scalar innovations in order, at least 2
   * @return −1 to 1; 0 if all are 0
   */
  public static double lagOneAutocorrelation(double[] innovations) {
    Require.atLeast("innovations", 2, innovations.length);
    double products = 0;
    double earlier = 0;
    double later = 0;
    for (int i = 1; i < innovations.length; i++) {
      products += innovations[i - 1] * innovations[i];
      earlier += innovations[i - 1] * innovations[i - 1];
      later += innovations[i] * innovations[i];
    }
    double scale = Math.sqrt(earlier * later);
    return scale == 0 ? 0 : products / scale;
  }

  /**
   * The band in which the lag-one autocorrelation of a white series lies.
   *
   * @param innovations how many the series has
   * @param confidence such as 0.95
   * @return around 0, half as wide as the normal quantile over the root of the number
   */
  public static Interval band(int innovations, double confidence) {
    Require.atLeast("innovations", 2, innovations);
    double rejected = 1 - confidence;
    double quantile = ChiSquaredDistribution.of(1).inverseSurvivalProbability(rejected);
    double half = Math.sqrt(quantile / (innovations - 1));
    return new Interval(-half, half);
  }
}
