package haltere.filters.wing.internal.search;

import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSearchSettings;

/**
 * Detects estimators at another frequency than that of the beat, such as half or double: another
 * frequency of the running spectrum of the events' mean position explains more than twice as much.
 * Frequencies within the half-power width of a peak do not differ.
 */
public final class FrequencyWatch {
  private static final int WINDOW_US = 30_000;
  private static final int MAX_EVENTS = 1000;

  /** Smallest explained share of a beat. */
  private static final double MIN_EXPLAINED = 0.25;

  private static final int CONFIRMATIONS = 2;

  private final BeatSpectrum spectrum = new BeatSpectrum();
  private int disagreements;
  private boolean agrees;

  /** A watch without events. */
  public FrequencyWatch() {}

  /** Restarts. */
  public void launch() {
    disagreements = 0;
    agrees = false;
  }

  /**
   * Compares the present spectrum with the frequencies of the estimators, about once in 10 ms.
   *
   * @param recent the newest events
   * @param nowUs end of the time window, microseconds
   * @param fly with the region of interest
   * @param settings the range of frequencies
   * @param hz frequencies of the wings' estimators; NaN for none
   */
  public void look(
      RecentEvents recent, long nowUs, FlyGeometry fly, WingSearchSettings settings, double... hz) {
    spectrum.clear();
    long fromUs = nowUs - WINDOW_US;
    int first = recent.indexAtOrAfter(fromUs);
    int step = 1 + (recent.size() - first) / MAX_EVENTS;
    double square = fly.sizePx() * fly.sizePx();
    for (int i = first; i < recent.size(); i += step) {
      double dx = recent.x(i) - fly.centreX();
      double dy = recent.y(i) - fly.centreY();
      if (dx * dx + dy * dy <= square && recent.timeUs(i) <= nowUs) {
        spectrum.add((recent.timeUs(i) - fromUs) * 1e-6, dx, dy);
      }
    }
    if (spectrum.settle()) {
      judge(settings, hz);
    }
  }

  private void judge(WingSearchSettings settings, double... all) {
    double min = 1;
    for (double hz : all) {
      min = Double.isNaN(hz) ? min : Math.min(min, spectrum.explainedNear(Math.max(1, hz)));
    }
    double max = min;
    if (BeatSpectrum.SIGNIFICANT_RATIO * min < 1) {
      max =
          spectrum.maxExplained(
              Math.min(settings.minFrequencyHz(), settings.maxFrequencyHz()),
              Math.max(settings.minFrequencyHz(), settings.maxFrequencyHz()));
    }
    if (max < MIN_EXPLAINED) {
      disagreements = 0;
      return;
    }
    agrees = BeatSpectrum.SIGNIFICANT_RATIO * min >= max;
    disagreements = agrees ? 0 : disagreements + 1;
  }

  /** {@return whether a frequency has differed from the spectrum twice in a row} */
  public boolean isWrong() {
    return disagreements >= CONFIRMATIONS;
  }

  /** {@return whether all frequencies agreed with the last usable spectrum} */
  public boolean isRight() {
    return agrees;
  }
}
