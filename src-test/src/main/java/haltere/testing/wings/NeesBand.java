package haltere.testing.wings;

import java.util.List;

/**
 * The band that holds the NEES of one scene in 95 % of cases if the standard deviations are right.
 *
 * <p>Errors of a scene are correlated over time and between both wings: a scene has far fewer
 * independent errors than ticks, so that chi squared with a degree of freedom for each tick is too
 * narrow. How errors go together cannot be seen in one scene: a heading that is off by little all
 * the time looks there like no error at all, where the next fly's is off by much. It is seen over
 * many scenes of a kind. For Gaussian errors the variance of the mean square is twice the mean
 * squared covariance over all pairs of ticks, and that is the mean squared product of the errors of
 * two different scenes (over ticks), without bias. So many independent errors as would give that
 * variance are the degrees of freedom of chi squared (Satterthwaite 1946).
 *
 * <p>Only how errors go together counts, not how large they are: the band is about 1, and a scene
 * that is off by more than its standard deviations counts for no more than one that is not, so that
 * bad scenes do not make the band wide.
 */
record NeesBand(double min, double max) {
  private static final double NINETY_FIVE_PERCENT = 1.96;

  /**
   * The band for scenes of a kind.
   *
   * @param scenes errors of each, one row a wing; at least two
   */
  static NeesBand of(List<NormalisedErrors[]> scenes) {
    int n = scenes.size();
    double[] weight = new double[n];
    double mean = 0;
    for (int i = 0; i < n; i++) {
      double own = NormalisedErrors.meanSquare(scenes.get(i));
      weight[i] = 1 / Math.sqrt(Math.max(1, own));
      mean += Math.min(1, own) / n;
    }
    double squares = 0;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < i; j++) {
        double product = NormalisedErrors.meanProduct(scenes.get(i), scenes.get(j));
        squares += Math.pow(weight[i] * weight[j] * product, 2);
      }
    }
    double freedom = mean * mean / (squares / (0.5 * n * (n - 1)));
    return new NeesBand(
        quantile(freedom, -NINETY_FIVE_PERCENT), quantile(freedom, NINETY_FIVE_PERCENT));
  }

  /** Of chi squared over its degrees of freedom (Wilson and Hilferty 1931). */
  private static double quantile(double freedom, double sd) {
    double a = 2 / (9 * freedom);
    double root = Math.max(0, 1 - a + sd * Math.sqrt(a));
    return root * root * root;
  }

  boolean contains(double nees) {
    return nees >= min && nees <= max;
  }

  /** Number of scenes within the band. */
  int count(List<NormalisedErrors[]> scenes) {
    return (int) scenes.stream().filter(s -> contains(NormalisedErrors.meanSquare(s))).count();
  }
}
