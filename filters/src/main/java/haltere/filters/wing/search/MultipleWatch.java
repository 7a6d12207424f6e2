package haltere.filters.wing.search;

import haltere.filters.wing.FlyGeometry;

/**
 * Notices a filter that beats at half or twice the wings' frequency: the running spectrum of the
 * events' mean place, which swings once a beat, then explains more at another multiple than at the
 * filter's own frequency.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class MultipleWatch {
  private static final int WINDOW_US = 30_000;
  private static final int MOST_EVENTS = 1000;
  private static final double[] MULTIPLES = {0.5, 2};

  /** How much more another multiple has to explain, and at least. */
  private static final double CLEARLY = 2;

  private static final double LEAST_EXPLAINED = 0.25;
  private static final int LOOKS = 2;

  /** Frequencies that differ by less than this share are judged as one. */
  private static final double ALIKE = 0.02;

  private final BeatSpectrum spectrum = new BeatSpectrum();
  private int wrong;

  /** A watch that has seen nothing. */
  public MultipleWatch() {}

  /** Begins anew. */
  public void launch() {
    wrong = 0;
  }

  /**
   * Looks at the spectrum as it is now, about once in ten milliseconds.
   *
   * @param recent the newest events
   * @param nowUs the end of the stretch that is looked at
   * @param fly whose region of interest counts
   */
  public void look(RecentEvents recent, long nowUs, FlyGeometry fly) {
    spectrum.clear();
    long fromUs = nowUs - WINDOW_US;
    int first = recent.indexAtOrAfter(fromUs);
    int step = 1 + (recent.size() - first) / MOST_EVENTS;
    double square = fly.sizePx() * fly.sizePx();
    for (int i = first; i < recent.size(); i += step) {
      double dx = recent.x(i) - fly.centreX();
      double dy = recent.y(i) - fly.centreY();
      if (dx * dx + dy * dy <= square && recent.timeUs(i) <= nowUs) {
        spectrum.add((recent.timeUs(i) - fromUs) * 1e-6, dx, dy);
      }
    }
  }

  /**
   * Judges the filters' frequencies by the spectrum that was looked at.
   *
   * @param leftHz of the left wing's filter; NaN if there is none
   * @param rightHz of the right wing's filter; NaN if there is none
   * @return true if one of them has been on a wrong multiple for two looks
   */
  public boolean isWrong(double leftHz, double rightHz) {
    boolean alike = Math.abs(leftHz - rightHz) < ALIKE * leftHz;
    boolean now = spectrum.settle() && (isWrong(leftHz) || !alike && isWrong(rightHz));
    wrong = now ? wrong + 1 : 0;
    return wrong >= LOOKS;
  }

  private boolean isWrong(double hz) {
    if (!(hz > 0)) {
      return false;
    }
    double own = spectrum.explainedNear(hz);
    for (double multiple : MULTIPLES) {
      double other = spectrum.explainedNear(multiple * hz);
      if (other > LEAST_EXPLAINED && other > CLEARLY * own) {
        return true;
      }
    }
    return false;
  }
}
