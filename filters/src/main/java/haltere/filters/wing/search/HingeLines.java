package haltere.filters.wing.search;

/**
 * The point where a wing is hinged: at any instant the events of one wing lie on a line through it.
 * Lines go through pairs of events that came shortly after each other; the point is the one nearest
 * to all of them by least squares with weights that fall off with the distance (Cauchy), which
 * narrow down from round to round.
 */
final class HingeLines {
  private static final double MOST_APART_S = 100e-6;
  private static final double LEAST_BASE_PX = 5;
  private static final double[] SCALES_PX = {16, 12, 8, 6, 4, 3, 2, 2};
  private static final int MOST_PARTNERS = 4;

  /** How freely the point may move from its start, standard deviation. */
  private static final double SLACK_PX = 15;

  /** The hinge. */
  double x;

  double y;

  /**
   * Searches from a point, among the events of the class of a side; false if there are too few
   * lines.
   */
  boolean search(StrokeSample sample, int side, byte[] classes, double startX, double startY) {
    x = startX;
    y = startY;
    for (double scale : SCALES_PX) {
      double prior = scale * scale / (SLACK_PX * SLACK_PX);
      double xx = prior;
      double yy = prior;
      double xy = 0;
      double bx = prior * (startX - x);
      double by = prior * (startY - y);
      int lines = 0;
      int from = 0;
      for (int i = 0; i < sample.size; i++) {
        if (!sample.supported[i] || classes[i] != side) {
          continue;
        }
        while (sample.timeS[i] - sample.timeS[from] > MOST_APART_S) {
          from++;
        }
        int partners = 0;
        for (int j = i - 1; j >= from && partners < MOST_PARTNERS; j--) {
          if (!sample.supported[j] || classes[j] != side || sample.sign[j] != sample.sign[i]) {
            continue;
          }
          partners++;
          double dx = sample.x[i] - sample.x[j];
          double dy = sample.y[i] - sample.y[j];
          double base = Math.sqrt(dx * dx + dy * dy);
          if (base < LEAST_BASE_PX) {
            continue;
          }
          double nx = -dy / base;
          double ny = dx / base;
          double mx = (sample.x[i] + sample.x[j]) / 2 - x;
          double my = (sample.y[i] + sample.y[j]) / 2 - y;
          double off = nx * mx + ny * my;
          // a line is the less sure at the hinge the further it is drawn out from its two events
          double startOut = Math.hypot(mx + x - startX, my + y - startY) / base;
          double scaled = off / scale;
          double w = 1 / ((1 + scaled * scaled) * (1 + startOut * startOut));
          xx += w * nx * nx;
          xy += w * nx * ny;
          yy += w * ny * ny;
          bx += w * nx * off;
          by += w * ny * off;
          lines++;
        }
      }
      if (lines < 10) {
        return false;
      }
      double det = xx * yy - xy * xy;
      x += (yy * bx - xy * by) / det;
      y += (xx * by - xy * bx) / det;
    }
    return true;
  }
}
