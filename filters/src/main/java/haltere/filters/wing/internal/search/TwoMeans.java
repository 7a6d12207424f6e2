package haltere.filters.wing.internal.search;

/**
 * Divides points into two classes by k-means (Lloyd 1982) from several starts; the division with
 * the least scatter is kept. An empty class gets the point furthest from the other mean.
 */
public final class TwoMeans {
  private static final int MAX_ROUNDS = 20;

  private double[] x;
  private double[] y;
  private int size;

  /** The two means. */
  double firstX;

  double firstY;
  double secondX;
  double secondY;

  /** Sum of the squared distances from the means. */
  double scatter;

  /** Means of no points. */
  public TwoMeans() {}

  /**
   * Divides points, from both diagonals of the sensor and both principal axes of the points.
   *
   * @param px columns
   * @param py rows
   * @param points how many of them
   * @param width of the sensor
   * @param height of the sensor
   * @return false if there are fewer than two different points
   */
  boolean divide(double[] px, double[] py, int points, int width, int height) {
    double meanX = 0;
    double meanY = 0;
    for (int i = 0; i < points; i++) {
      meanX += px[i];
      meanY += py[i];
    }
    meanX /= points;
    meanY /= points;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (int i = 0; i < points; i++) {
      xx += (px[i] - meanX) * (px[i] - meanX);
      xy += (px[i] - meanX) * (py[i] - meanY);
      yy += (py[i] - meanY) * (py[i] - meanY);
    }
    if (!(xx + yy > 0)) {
      return false;
    }
    double axis = 0.5 * Math.atan2(2 * xy, xx - yy);
    double reach = Math.sqrt((xx + yy) / points);
    double dx = reach * Math.cos(axis);
    double dy = reach * Math.sin(axis);
    double[][] starts = {
      {width - 1.0, height - 1.0, 0, 0},
      {0, height - 1.0, width - 1.0, 0},
      {meanX + dx, meanY + dy, meanX - dx, meanY - dy},
      {meanX - dy, meanY + dx, meanX + dy, meanY - dx}
    };
    divide(px, py, points, starts);
    return true;
  }

  /**
   * Divides points.
   *
   * @param px columns
   * @param py rows
   * @param points how many of them
   * @param starts initial means: x, y, x, y; each is overwritten by its result
   */
  public void divide(double[] px, double[] py, int points, double[]... starts) {
    x = px;
    y = py;
    size = points;
    scatter = Double.POSITIVE_INFINITY;
    for (double[] start : starts) {
      double found = converge(start);
      if (found < scatter) {
        scatter = found;
        firstX = start[0];
        firstY = start[1];
        secondX = start[2];
        secondY = start[3];
      }
    }
  }

  /** Iterates until the means do not change; returns the scatter. */
  private double converge(double[] means) {
    double before = Double.POSITIVE_INFINITY;
    for (int round = 0; round < MAX_ROUNDS; round++) {
      double now = improve(means);
      if (!(now < before)) {
        break;
      }
      before = now;
    }
    return before;
  }

  private double improve(double[] means) {
    double n1 = 0;
    double x1 = 0;
    double y1 = 0;
    double x2 = 0;
    double y2 = 0;
    double sum = 0;
    double far1 = -1;
    double far2 = -1;
    int furthest1 = 0;
    int furthest2 = 0;
    for (int i = 0; i < size; i++) {
      double d1 = square(x[i] - means[0]) + square(y[i] - means[1]);
      double d2 = square(x[i] - means[2]) + square(y[i] - means[3]);
      if (d1 < d2) {
        n1++;
        x1 += x[i];
        y1 += y[i];
        sum += d1;
      } else {
        x2 += x[i];
        y2 += y[i];
        sum += d2;
      }
      if (d1 > far1) {
        far1 = d1;
        furthest1 = i;
      }
      if (d2 > far2) {
        far2 = d2;
        furthest2 = i;
      }
    }
    double n2 = size - n1;
    means[0] = n1 > 0 ? x1 / n1 : x[furthest2];
    means[1] = n1 > 0 ? y1 / n1 : y[furthest2];
    means[2] = n2 > 0 ? x2 / n2 : x[furthest1];
    means[3] = n2 > 0 ? y2 / n2 : y[furthest1];
    return n1 > 0 && n2 > 0 ? sum : Double.MAX_VALUE;
  }

  private static double square(double value) {
    return value * value;
  }
}
