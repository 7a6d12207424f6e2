package haltere.core.simulation.internal.fly;

import java.util.Arrays;

/**
 * Shares of the pixels that polygons cover, exact: each edge adds, to the pixels that it crosses,
 * the area to the right of it in its own pixel and its height to those further right, so that sums
 * along the rows are the areas. Polygons that overlap add up.
 *
 * <p>Thread rule: one thread at a time.
 */
final class CoverageRaster {
  private final int width;
  private final int height;
  private final double[] cover;

  /** Columns of each row that are not empty, the last one exclusive. */
  private final int[] from;

  private final int[] to;

  /** Rows that are not empty, the last one exclusive. */
  private int fromRow;

  private int toRow;

  CoverageRaster(int width, int height) {
    this.width = width;
    this.height = height;
    cover = new double[(width + 1) * height];
    from = new int[height];
    to = new int[height];
    Arrays.fill(from, width);
    fromRow = height;
  }

  /** Removes all polygons. */
  void clear() {
    for (int y = fromRow; y < toRow; y++) {
      Arrays.fill(cover, y * (width + 1), y * (width + 1) + Math.min(width, to[y]) + 1, 0);
      from[y] = width;
      to[y] = 0;
    }
    fromRow = height;
    toRow = 0;
  }

  /** Adds a polygon; corners in pixels, whole numbers at the centres of pixels. */
  void add(double[] x, double[] y, int corners) {
    for (int i = 0, last = corners - 1; i < corners; last = i++) {
      if (y[last] < y[i]) {
        edge(x[last] + 0.5, y[last] + 0.5, x[i] + 0.5, y[i] + 0.5, 1);
      } else if (y[last] > y[i]) {
        edge(x[i] + 0.5, y[i] + 0.5, x[last] + 0.5, y[last] + 0.5, -1);
      }
    }
  }

  /** Adds an edge that goes up. */
  private void edge(double x0, double y0, double x1, double y1, double sign) {
    int first = (int) Math.max(0, Math.floor(y0));
    int end = (int) Math.min(height, Math.ceil(y1));
    fromRow = Math.min(fromRow, first);
    toRow = Math.max(toRow, end);
    double slope = (x1 - x0) / (y1 - y0);
    for (int row = first; row < end; row++) {
      double low = Math.max(y0, row);
      double high = Math.min(y1, row + 1);
      double a = x0 + (low - y0) * slope;
      double b = high == y1 ? x1 : x0 + (high - y0) * slope;
      piece(row, Math.min(a, b), Math.max(a, b), sign * (high - low));
    }
  }

  /** Adds a piece of an edge within a row, from left to right. */
  private void piece(int row, double a, double b, double rise) {
    int line = row * (width + 1);
    int left = (int) Math.max(0, Math.floor(a));
    from[row] = Math.min(from[row], left);
    to[row] = Math.max(to[row], (int) Math.min(width, Math.floor(b) + 1));
    double perPx = b > a ? rise / (b - a) : 0;
    double done = Math.max(0, a);
    if (b <= 0) {
      cover[line] += rise;
      return;
    }
    if (a < 0) {
      cover[line] -= a * perPx;
    }
    for (int column = left; column < width; column++) {
      boolean ends = b <= column + 1;
      double until = ends ? b : column + 1;
      double part = b > a ? (until - done) * perPx : rise;
      double share = (done + until) / 2 - column;
      cover[line + column] += part * (1 - share);
      cover[line + column + 1] += part * share;
      if (ends) {
        return;
      }
      done = until;
    }
  }

  /** Sums up; from then on, {@link #at} has the shares. */
  void finish() {
    for (int y = fromRow; y < toRow; y++) {
      double sum = 0;
      int line = y * (width + 1);
      for (int i = line + from[y]; i < line + to[y]; i++) {
        sum += cover[i];
        cover[i] = sum;
      }
    }
  }

  /** Share of a pixel that is covered. */
  double at(int x, int y) {
    return Math.min(1, Math.abs(cover[y * (width + 1) + x]));
  }

  int fromRow() {
    return fromRow;
  }

  int toRow() {
    return toRow;
  }

  int from(int row) {
    return from[row];
  }

  int to(int row) {
    return to[row];
  }
}
