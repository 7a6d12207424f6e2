package haltere.filters.wing.internal.search;

import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSearchSettings;

/**
 * Notices estimators at another frequency than that of the beat, such as half or twice of it: a
 * frequency contradicts the running spectrum of the events' mean position if another one explains
 * more than twice as much of how that swings. Two frequencies within the half-power width of a peak
 * of the spectrum do not contradict each other.
 */
public final class FrequencyWatch {
  private static final int WINDOW_US = 30_000;
  private static final int MAX_EVENTS = 1000;

  /** Share of the swing that a frequency has to explain to be the beat. */
  private static final double MIN_EXPLAINED = 0.25;

  private static final int LOOKS = 2;

  private final BeatSpectrum spectrum = new BeatSpectrum();
  private int wrong;
  private boolean right;

  /** A watch that has seen nothing. */
  public FrequencyWatch() {}

  /** Begins anew. */
  public void launch() {
    wrong = 0;
    right = false;
  }

  /**
   * Looks at the spectrum as it is now, about once in ten milliseconds, and judges the frequencies
   * of the estimators.
   *
   * @param recent the newest events
   * @param nowUs the end of the stretch that is looked at
   * @param fly whose region of interest counts
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
    double least = 1;
    for (double hz : all) {
      least = Double.isNaN(hz) ? least : Math.min(least, spectrum.explainedNear(Math.max(1, hz)));
    }
    double most = least;
    if (BeatSpectrum.CLEARLY * least < 1) {
      most =
          spectrum.mostExplained(
              Math.min(settings.leastFrequencyHz(), settings.mostFrequencyHz()),
              Math.max(settings.leastFrequencyHz(), settings.mostFrequencyHz()));
    }
    if (most < MIN_EXPLAINED) {
      wrong = 0;
      return;
    }
    right = BeatSpectrum.CLEARLY * least >= most;
    wrong = right ? 0 : wrong + 1;
  }

  /** {@return whether a frequency has contradicted the spectrum for two looks} */
  public boolean isWrong() {
    return wrong >= LOOKS;
  }

  /** {@return whether all frequencies explained the events when that could last be told} */
  public boolean isRight() {
    return right;
  }
}
