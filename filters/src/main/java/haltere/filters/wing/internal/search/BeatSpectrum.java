package haltere.filters.wing.internal.search;

import java.util.Arrays;

/**
 * Spectrum of the events' mean position: a least-squares sinusoid with a free mean through the mean
 * positions of short bins, weighted by their events, for every frequency of a grid (Lomb-Scargle
 * periodogram with floating mean, Zechmeister and Kuerster 2009). The direction of the oscillation
 * is the body axis. The mean position oscillates once a beat and the number of events twice, which
 * excludes half and double frequencies.
 */
final class BeatSpectrum {
  /** Ratio of explained variances above which two frequencies differ: half power. */
  static final double SIGNIFICANT_RATIO = 2;

  private static final double BIN_S = 250e-6;
  private static final double STEP_HZ = 1;
  private static final int BINS = 1024;
  private static final double NEAR_STEP = 0.03;
  private static final double NEAR_SHARE = 2 * NEAR_STEP;

  private final double[] weight = new double[BINS];
  private final double[] sumX = new double[BINS];
  private final double[] sumY = new double[BINS];
  private final double[] fit = new double[4];
  private int bins;
  private double meanX;
  private double meanY;
  private double scatter;

  /** The frequency that was found, hertz. */
  double frequencyHz;

  /** Explained share of the variance of the mean positions, 0 to 1. */
  double explained;

  /** Direction of the oscillation, radians, modulo pi. */
  double axisRad;

  void clear() {
    bins = 0;
    Arrays.fill(weight, 0);
    Arrays.fill(sumX, 0);
    Arrays.fill(sumY, 0);
  }

  /** Adds an event, at a time after the start. */
  void add(double timeS, double x, double y) {
    int bin = (int) (timeS / BIN_S);
    if (bin >= 0 && bin < BINS) {
      weight[bin]++;
      sumX[bin] += x;
      sumY[bin] += y;
      bins = Math.max(bins, bin + 1);
    }
  }

  /**
   * Searches a range of frequencies.
   *
   * @return false if there are too few events
   */
  boolean search(double fromHz, double toHz) {
    if (!settle()) {
      return false;
    }
    double bestHz = bestOf(fromHz, toHz, STEP_HZ);
    double best = gain(bestHz);
    double before = gain(bestHz - STEP_HZ);
    double after = gain(bestHz + STEP_HZ);
    double curve = before - 2 * best + after;
    double shift = curve < 0 ? 0.5 * (before - after) / curve : 0;
    frequencyHz = bestHz + STEP_HZ * Math.max(-1, Math.min(1, shift));
    explained = gain(frequencyHz) / scatter;
    double xx = fit[0] * fit[0] + fit[1] * fit[1];
    double yy = fit[2] * fit[2] + fit[3] * fit[3];
    double xy = fit[0] * fit[2] + fit[1] * fit[3];
    axisRad = 0.5 * Math.atan2(2 * xy, xx - yy);
    return true;
  }

  /** The frequency of an even series with the largest explained share. */
  private double bestOf(double fromHz, double toHz, double stepHz) {
    double best = -1;
    double bestHz = fromHz;
    for (double hz = fromHz; hz <= toHz; hz += stepHz) {
      double gain = gain(hz);
      if (gain > best) {
        best = gain;
        bestHz = hz;
      }
    }
    return bestHz;
  }

  /** Explained share near a frequency, 0 to 1, after {@link #settle}. */
  double explainedNear(double hz) {
    return gain(bestOf(hz * (1 - NEAR_SHARE), hz * (1 + NEAR_SHARE) + 1e-9, hz * NEAR_STEP))
        / scatter;
  }

  /** Largest explained share of a range, in steps of half the resolution. */
  double maxExplained(double fromHz, double toHz) {
    return gain(bestOf(fromHz, toHz, 0.5 / (bins * BIN_S))) / scatter;
  }

  /**
   * Computes the mean position and the variance about it.
   *
   * @return false if there are too few events
   */
  boolean settle() {
    double total = 0;
    meanX = 0;
    meanY = 0;
    for (int b = 0; b < bins; b++) {
      total += weight[b];
      meanX += sumX[b];
      meanY += sumY[b];
    }
    if (total < 10) {
      return false;
    }
    meanX /= total;
    meanY /= total;
    scatter = 0;
    for (int b = 0; b < bins; b++) {
      if (weight[b] > 0) {
        double dx = sumX[b] - weight[b] * meanX;
        double dy = sumY[b] - weight[b] * meanY;
        scatter += (dx * dx + dy * dy) / weight[b];
      }
    }
    return scatter > 0;
  }

  /** Variance explained by the best sinusoid of a frequency. */
  private double gain(double hz) {
    double turn = 2 * Math.PI * hz * BIN_S;
    double stepC = Math.cos(turn);
    double stepS = Math.sin(turn);
    double c = 1;
    double s = 0;
    double w = 0;
    double wc = 0;
    double ws = 0;
    double wcc = 0;
    double wcs = 0;
    double xc = 0;
    double xs = 0;
    double yc = 0;
    double ys = 0;
    for (int b = 0; b < bins; b++) {
      double n = weight[b];
      if (n > 0) {
        double dx = sumX[b] - n * meanX;
        double dy = sumY[b] - n * meanY;
        w += n;
        wc += n * c;
        ws += n * s;
        wcc += n * c * c;
        wcs += n * c * s;
        xc += dx * c;
        xs += dx * s;
        yc += dy * c;
        ys += dy * s;
      }
      double next = c * stepC - s * stepS;
      s = s * stepC + c * stepS;
      c = next;
    }
    double cc = wcc - wc * wc / w;
    double ss = w - wcc - ws * ws / w;
    double cs = wcs - wc * ws / w;
    double det = cc * ss - cs * cs;
    if (!(det > 1e-6 * w * w)) {
      return 0;
    }
    fit[0] = (ss * xc - cs * xs) / det;
    fit[1] = (cc * xs - cs * xc) / det;
    fit[2] = (ss * yc - cs * ys) / det;
    fit[3] = (cc * ys - cs * yc) / det;
    return fit[0] * xc + fit[1] * xs + fit[2] * yc + fit[3] * ys;
  }
}
