package haltere.filters.wing.internal.search;

/** Finds the sinusoid with the most events of a wing near it, as a start of {@link StrokeFit}. */
final class CoarseStroke {
  private static final int EVENTS = 500;
  private static final int MIN_EVENTS = 40;
  private static final int PHASES = 24;
  private static final double[] CENTRES = {1.35, 1.57, 1.8};
  private static final double[] AMPLITUDES = {0.45, 0.65, 0.85, 1.05, 1.25, 1.45};
  private static final double NEAR_RAD = 0.15;
  private static final double MIN_SQUARE_PX = 9;

  private final double[] angle = new double[2 * EVENTS + 2];
  private final double[] cos = new double[angle.length];
  private final double[] sin = new double[angle.length];
  private int size;

  /** Centre and terms of the sinusoid that was found. */
  double centre;

  double cosine;
  double sine;

  /**
   * Searches the events of a side about a hinge, neither too near nor too far; false if there are
   * too few. Angles are measured from a direction, counterclockwise for turn 1, clockwise for −1;
   * phases are of an angular frequency, 0 at a time. The centre is beyond π/2 for end 1, not for
   * −1.
   */
  boolean search(
      SideSplit split,
      int side,
      double hingeX,
      double hingeY,
      double outerPx,
      double referenceRad,
      double turn,
      double omega,
      double middleS,
      int end) {
    StrokeSample sample = split.sample;
    int stride = Math.max(1, split.count(side) / EVENTS);
    int seen = 0;
    size = 0;
    for (int i = 0; i < sample.size; i++) {
      if (split.isOn(side, i) && seen++ % stride == 0) {
        double dx = sample.x[i] - hingeX;
        double dy = sample.y[i] - hingeY;
        double rr = dx * dx + dy * dy;
        if (rr >= MIN_SQUARE_PX && rr <= outerPx * outerPx) {
          double phase = omega * (sample.timeS[i] - middleS);
          angle[size] = StrokeFit.near(turn * (Math.atan2(dy, dx) - referenceRad), Math.PI / 2);
          cos[size] = Math.cos(phase);
          sin[size++] = Math.sin(phase);
        }
      }
    }
    if (size < MIN_EVENTS) {
      return false;
    }
    double best = -1;
    for (int k = 0; k < PHASES; k++) {
      double pc = Math.cos(2 * Math.PI * k / PHASES);
      double ps = Math.sin(2 * Math.PI * k / PHASES);
      for (double amplitude : AMPLITUDES) {
        for (double middle : CENTRES) {
          double score = score(middle, amplitude * pc, amplitude * ps);
          if (score > best && end * (middle - CENTRES[1]) >= 0) {
            best = score;
            centre = middle;
            cosine = amplitude * pc;
            sine = amplitude * ps;
          }
        }
      }
    }
    return true;
  }

  private double score(double middle, double c, double s) {
    double score = 0;
    for (int i = 0; i < size; i++) {
      double y = (angle[i] - middle - (c * cos[i] + s * sin[i])) / NEAR_RAD;
      score += 1 / (1 + y * y);
    }
    return score;
  }
}
