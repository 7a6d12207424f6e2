package haltere.ui.viewer.playback;

import java.util.Arrays;

/**
 * Heights of event rates in the time bar, robust against single bursts: linear up to a percentile
 * of the rates, or logarithmic.
 *
 * <p>Thread rule: any thread.
 */
final class RateScale {
  /** Share of the columns with events that are not clipped. */
  private static final double UNCLIPPED = 0.97;

  /** Decades of rate that the logarithmic scale has below the highest rate. */
  private static final double DECADES = 3;

  private RateScale() {}

  /**
   * Heights of columns for rates of events per second, 0 to 1; above 1, to be clipped, for those
   * beyond the percentile. Logarithmic, a decade has the same height everywhere.
   */
  static double[] heights(double[] rates, boolean logarithmic) {
    double[] sorted = Arrays.stream(rates).filter(rate -> rate > 0).sorted().toArray();
    if (sorted.length == 0) {
      return new double[rates.length];
    }
    double highest = sorted[sorted.length - 1];
    double full = sorted[(int) Math.floor(UNCLIPPED * (sorted.length - 1))];
    return Arrays.stream(rates)
        .map(rate -> logarithmic ? logarithmic(rate / highest) : rate / full)
        .toArray();
  }

  private static double logarithmic(double share) {
    return share <= 0 ? 0 : Math.max(0, 1 + Math.log10(share) / DECADES);
  }
}
