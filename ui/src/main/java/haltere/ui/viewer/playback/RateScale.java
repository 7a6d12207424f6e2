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

  private RateScale() {}

  /**
   * Heights of columns for rates of events per second, 0 to 1; above 1, to be clipped, for those
   * beyond the percentile. The logarithmic scale begins a decade below the lowest rate with events,
   * so that a burst leaves height for the others; each decade has the same height.
   */
  static double[] heights(double[] rates, boolean logarithmic) {
    double[] sorted = Arrays.stream(rates).filter(rate -> rate > 0).sorted().toArray();
    if (sorted.length == 0) {
      return new double[rates.length];
    }
    double highest = sorted[sorted.length - 1];
    double full = sorted[(int) Math.floor(UNCLIPPED * (sorted.length - 1))];
    double decades = 1 + Math.log10(highest / sorted[0]);
    return Arrays.stream(rates)
        .map(rate -> logarithmic ? 1 + Math.log10(rate / highest) / decades : rate / full)
        .map(height -> Math.max(0, height))
        .toArray();
  }
}
