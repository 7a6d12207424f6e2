package haltere.filters.frequency;

/**
 * Estimates the period of a series of counts: the shortest lag at which the autocorrelation is near
 * its maximum, refined by the multiples of that lag.
 *
 * <p>Thread rule: one thread at a time.
 */
final class Periodicity {
  /** Minimum number of values in a period. */
  private static final int MIN_VALUES = 2;

  /** Minimum number of periods in the series. */
  private static final int PERIODS = 4;

  /** Minimum height of a peak, as a share of the variance. */
  private static final double MIN_CORRELATION = 0.12;

  /** Minimum number of pairs of counts a period apart; few scattered counts have some by chance. */
  private static final double MIN_PAIRS = 8;

  /** Minimum height of the period's peak, as a share of the highest one. */
  private static final double MIN_SHARE_OF_HIGHEST = 0.8;

  /** Share to which the correlation must fall before the next period. */
  private static final double FALLEN = 0.5;

  /** Divisor of the period for smoothing, which reduces the noise of long periods. */
  private static final int SMOOTHING = 16;

  /** Largest relative change of the period by its next multiple. */
  private static final double MAX_CHANGE = 0.1;

  private final double[] correlation;
  private final float[] centred;

  Periodicity(int longest) {
    correlation = new double[longest / PERIODS + 2];
    centred = new float[longest];
  }

  /** The period of a number of equidistant counts, in their distances; NaN if there is none. */
  double periodOf(float[] values, int count) {
    int lags = count / PERIODS;
    if (lags <= MIN_VALUES + 1) {
      return Double.NaN;
    }
    double mean = 0;
    for (int i = 0; i < count; i++) {
      mean += values[i];
    }
    mean /= count;
    for (int i = 0; i < count; i++) {
      centred[i] = (float) (values[i] - mean);
    }
    // all lags have the same number of products, so that long ones have equal weight
    int used = count - lags - 1;
    for (int lag = 0; lag <= lags + 1 && lag < correlation.length; lag++) {
      correlation[lag] = product(centred, lag, used);
    }
    int first = firstFall(lags);
    double highest = 0;
    for (int lag = first; lag <= lags; lag++) {
      highest = Math.max(highest, correlation[lag]);
    }
    if (first > lags || !(highest > Math.max(MIN_PAIRS, MIN_CORRELATION * correlation[0]))) {
      return Double.NaN;
    }
    for (int lag = first; lag <= lags; lag++) {
      if (correlation[lag] >= MIN_SHARE_OF_HIGHEST * highest) {
        return refined(highestNear(lag, lag + lag / 4 + 1, lags, lag / SMOOTHING), lags);
      }
    }
    return Double.NaN;
  }

  /** The lag after which a rise belongs to the next period. */
  private int firstFall(int lags) {
    int lag = MIN_VALUES;
    while (lag <= lags && correlation[lag] > FALLEN * Math.max(correlation[1], 0)) {
      lag++;
    }
    // a falling correlation is not a peak
    while (lag <= lags && correlation[lag] <= correlation[lag - 1]) {
      lag++;
    }
    return lag;
  }

  private static double product(float[] values, int lag, int used) {
    // four independent sums, since a single one would be limited by the latency of additions
    double a = 0;
    double b = 0;
    double c = 0;
    double d = 0;
    int i = 0;
    for (; i + 3 < used; i += 4) {
      a += values[i] * values[i + lag];
      b += values[i + 1] * values[i + 1 + lag];
      c += values[i + 2] * values[i + 2 + lag];
      d += values[i + 3] * values[i + 3 + lag];
    }
    for (; i < used; i++) {
      a += values[i] * values[i + lag];
    }
    return a + b + c + d;
  }

  /** The lag of the highest mean in a range. */
  private int highestNear(int from, int to, int lags, int reach) {
    int best = Math.min(from, lags);
    for (int lag = best; lag <= Math.min(to, lags); lag++) {
      if (mean(lag, reach) > mean(best, reach)) {
        best = lag;
      }
    }
    return best;
  }

  private double mean(int lag, int reach) {
    int from = Math.max(0, lag - reach);
    int to = Math.min(correlation.length - 1, lag + reach);
    double sum = 0;
    for (int i = from; i <= to; i++) {
      sum += correlation[i];
    }
    return sum / (to - from + 1);
  }

  /** Refines the period with each multiple of the peak. */
  private double refined(int lag, int lags) {
    int reach = lag / SMOOTHING;
    double period = top(lag, reach);
    for (int multiple = 2; multiple * period + reach + 2 <= lags; multiple++) {
      int near = (int) Math.rint(multiple * period);
      int around = 1 + reach / 2;
      int best = highestNear(near - around, near + around, lags, reach);
      double exact = top(best, reach) / multiple;
      if (!(Math.abs(exact - period) <= MAX_CHANGE * period)) {
        // not a multiple: the repetition is short
        break;
      }
      period = exact;
    }
    return period;
  }

  /** Top of the parabola through a peak and its neighbours. */
  private double top(int lag, int reach) {
    int step = 1 + reach;
    double before = mean(lag - step, reach);
    double here = mean(lag, reach);
    double after = mean(lag + step, reach);
    double bend = before - 2 * here + after;
    double off = bend < 0 ? 0.5 * step * (before - after) / bend : 0;
    return lag + Math.max(-step, Math.min(step, off));
  }
}
