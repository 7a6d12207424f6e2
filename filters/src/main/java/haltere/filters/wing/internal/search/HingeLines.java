package haltere.filters.wing.internal.search;

/**
 * The hinge of a wing: at any instant the events of the wing are on a line through it. Lines go
 * through pairs of successive events; the hinge is the nearest point by iterated least squares with
 * Cauchy weights of decreasing width.
 */
final class HingeLines {
  private static final double MAX_APART_S = 100e-6;
  private static final double MIN_BASE_PX = 5;
  private static final double[] SCALES_PX = {16, 12, 8, 6, 4, 3, 2, 2};
  private static final int MAX_PARTNERS = 4;

  /** Prior standard deviation of the hinge about its start. */
  private static final double SLACK_PX = 15;

  /** The hinge. */
  double x;

  double y;

  private final NormalEquations normal = new NormalEquations(2);
  private final double[] row = new double[2];
  private final double[] step = new double[2];

  /** Searches from a point in the events of a side; false if there are too few lines. */
  boolean search(SideSplit split, int side, double startX, double startY) {
    StrokeSample sample = split.sample;
    x = startX;
    y = startY;
    for (double scale : SCALES_PX) {
      normal.clear();
      normal.addPrior(0, startX - x, SLACK_PX / scale);
      normal.addPrior(1, startY - y, SLACK_PX / scale);
      int lines = 0;
      int from = 0;
      for (int i = 0; i < sample.size; i++) {
        if (!sample.supported[i] || !split.isOn(side, i)) {
          continue;
        }
        while (sample.timeS[i] - sample.timeS[from] > MAX_APART_S) {
          from++;
        }
        int partners = 0;
        for (int j = i - 1; j >= from && partners < MAX_PARTNERS; j--) {
          if (sample.supported[j] && split.isOn(side, j) && sample.sign[j] == sample.sign[i]) {
            partners++;
            lines += add(sample, i, j, scale, startX, startY) ? 1 : 0;
          }
        }
      }
      if (lines < 10 || !normal.solve(2, step)) {
        return false;
      }
      x += step[0];
      y += step[1];
    }
    return true;
  }

  /** Adds the line through two events; false if they are too close. */
  private boolean add(
      StrokeSample sample, int i, int j, double scale, double startX, double startY) {
    double dx = sample.x[i] - sample.x[j];
    double dy = sample.y[i] - sample.y[j];
    double base = Math.sqrt(dx * dx + dy * dy);
    if (base < MIN_BASE_PX) {
      return false;
    }
    row[0] = -dy / base;
    row[1] = dx / base;
    double mx = (sample.x[i] + sample.x[j]) / 2;
    double my = (sample.y[i] + sample.y[j]) / 2;
    double off = row[0] * (mx - x) + row[1] * (my - y);
    // a line is the less sure at the hinge the further it is drawn out from its two events
    double startOut = Math.hypot(mx - startX, my - startY) / base;
    double scaled = off / scale;
    normal.add(1 / ((1 + scaled * scaled) * (1 + startOut * startOut)), row, 2, off);
    return true;
  }
}
