package haltere.filters.object;

import java.util.Arrays;

/**
 * Where in an object its events come from: a grid of cells that moves with the object and holds the
 * decaying weight of its events. Smoothed and normalised it is the spatial density of the object's
 * events; the gradient of its logarithm tells a displacement.
 *
 * <p>Pixels. Thread rule: one thread at a time.
 */
final class ShapeTemplate {
  /** Cells of a side. */
  static final int SIDE = 24;

  static final int CELLS = SIDE * SIDE;

  /** Least side of a cell: pixels are not known better. */
  static final double MIN_CELL_PX = 1.5;

  /** Memory of the shape, seconds: limbs and turns change it within. */
  static final double MEMORY_S = 0.3;

  /** Share of the events that come from beside the shape seen so far: it grows or bends. */
  private static final double GROWTH = 0.05;

  private static final int RADIUS = 2;

  /** Share of the mean density below which a cell does not belong to the extent. */
  private static final double FAINT = 0.1;

  /** Share of the mean density below which a cell does not connect two others. */
  private static final double SPARSE = 0.3;

  /** Cells of the extent. */
  private final boolean[] solid = new boolean[CELLS];

  /** Cells that connect: those of the extent that are not sparse. */
  final boolean[] core = new boolean[CELLS];

  /** Cells that an object's longer side should span: between both, it is not rescaled. */
  private static final double MIN_SPAN = SIDE * 0.5;

  private static final double MAX_SPAN = SIDE * 0.8;

  /** Share of the weight beyond either end of an extent. */
  private static final double TAIL = 0.02;

  final float[] mass = new float[CELLS];
  final float[] density = new float[CELLS];
  final float[] gradientX = new float[CELLS];
  final float[] gradientY = new float[CELLS];
  private final float[] work = new float[CELLS];
  double cellPx = MIN_CELL_PX;
  double total;
  double solidTotal;

  /** Fisher information of one event about a displacement, per square pixel. */
  double infoXx;

  double infoXy;
  double infoYy;

  /** Middle and half axes of the extent, relative to the middle of the grid. */
  double middleX;

  double middleY;

  /** Covariance of the extent's events, px². */
  double varianceX;

  double covarianceXy;
  double varianceY;

  /** Half sides of the box along x and y. */
  double halfX;

  double halfY;

  void clear(double cell) {
    Arrays.fill(mass, 0);
    cellPx = cell;
    total = 0;
  }

  void copy(ShapeTemplate other) {
    System.arraycopy(other.mass, 0, mass, 0, CELLS);
    cellPx = other.cellPx;
    total = other.total;
    refresh();
  }

  /** Cell of an offset from the middle of the grid; -1 outside. */
  int cell(double dx, double dy) {
    int column = (int) Math.floor(dx / cellPx + SIDE / 2.0);
    int row = (int) Math.floor(dy / cellPx + SIDE / 2.0);
    return column < 0 || column >= SIDE || row < 0 || row >= SIDE ? -1 : row * SIDE + column;
  }

  static double x(int cell) {
    return (cell % SIDE) + 0.5 - SIDE / 2.0;
  }

  static double y(int cell) {
    return (cell / SIDE) + 0.5 - SIDE / 2.0;
  }

  void decay(double keep) {
    for (int i = 0; i < CELLS; i++) {
      mass[i] *= (float) keep;
    }
    total *= keep;
  }

  void add(int cell, double weight) {
    mass[cell] += (float) weight;
    total += weight;
  }

  /** Works out the density, its gradient, and the extent. */
  void refresh() {
    smooth();
    double sum = 0;
    for (int i = 0; i < CELLS; i++) {
      sum += work[i];
    }
    float scale = (float) (sum > 0 ? 1 / sum : 0);
    float floor = (float) (1e-3 / CELLS);
    widen();
    for (int i = 0; i < CELLS; i++) {
      density[i] = (float) ((1 - GROWTH) * work[i] + GROWTH * wide[i]) * scale + floor;
    }
    infoXx = 0;
    infoXy = 0;
    infoYy = 0;
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        int i = row * SIDE + column;
        double d = density[i];
        double left = column > 0 ? density[i - 1] : floor;
        double right = column < SIDE - 1 ? density[i + 1] : floor;
        double below = row > 0 ? density[i - SIDE] : floor;
        double above = row < SIDE - 1 ? density[i + SIDE] : floor;
        // d ln f from the logarithm's own differences: bounded where the density is the floor
        double gx = (right - left) / (right + left + d) * 1.5 / cellPx;
        double gy = (above - below) / (above + below + d) * 1.5 / cellPx;
        gradientX[i] = (float) gx;
        gradientY[i] = (float) gy;
        infoXx += d * gx * gx;
        infoXy += d * gx * gy;
        infoYy += d * gy * gy;
      }
    }
    measureExtent();
  }

  /** Binomial smoothing over three cells each way. */
  private void smooth() {
    for (int row = 0; row < SIDE; row++) {
      int at = row * SIDE;
      for (int c = 0; c < SIDE; c++) {
        float left = c > 0 ? mass[at + c - 1] : 0;
        float right = c < SIDE - 1 ? mass[at + c + 1] : 0;
        density[at + c] = 0.25f * (left + right) + 0.5f * mass[at + c];
      }
    }
    for (int i = 0; i < CELLS; i++) {
      float below = i >= SIDE ? density[i - SIDE] : 0;
      float above = i < CELLS - SIDE ? density[i + SIDE] : 0;
      work[i] = 0.25f * (below + above) + 0.5f * density[i];
    }
  }

  private final float[] wide = new float[CELLS];
  private final float[] lane = new float[CELLS];

  /** The smoothed weight spread over squares of 2 RADIUS + 1 cells: where the object may grow. */
  private void widen() {
    float share = 1f / (2 * RADIUS + 1);
    for (int row = 0; row < SIDE; row++) {
      int at = row * SIDE;
      float run = 0;
      for (int c = 0; c < RADIUS; c++) {
        run += work[at + c];
      }
      for (int c = 0; c < SIDE; c++) {
        run += c + RADIUS < SIDE ? work[at + c + RADIUS] : 0;
        lane[at + c] = run * share;
        run -= c - RADIUS >= 0 ? work[at + c - RADIUS] : 0;
      }
    }
    for (int c = 0; c < SIDE; c++) {
      float run = 0;
      for (int r = 0; r < RADIUS; r++) {
        run += lane[r * SIDE + c];
      }
      for (int r = 0; r < SIDE; r++) {
        run += r + RADIUS < SIDE ? lane[(r + RADIUS) * SIDE + c] : 0;
        wide[r * SIDE + c] = run * share;
        run -= r - RADIUS >= 0 ? lane[(r - RADIUS) * SIDE + c] : 0;
      }
    }
  }

  private final float[] marginalX = new float[SIDE];
  private final float[] marginalY = new float[SIDE];

  private void measureExtent() {
    if (!(total > 0)) {
      return;
    }
    double mean = 0;
    for (int i = 0; i < CELLS; i++) {
      mean += density[i] * density[i];
    }
    double threshold = FAINT * mean;
    double mx = 0;
    double my = 0;
    solidTotal = 0;
    Arrays.fill(marginalX, 0);
    Arrays.fill(marginalY, 0);
    for (int i = 0; i < CELLS; i++) {
      solid[i] = density[i] > threshold;
      core[i] = density[i] > SPARSE * mean;
      if (solid[i]) {
        float m = mass[i];
        marginalX[i % SIDE] += m;
        marginalY[i / SIDE] += m;
        mx += m * x(i);
        my += m * y(i);
        solidTotal += m;
      }
    }
    if (!(solidTotal > 0)) {
      return;
    }
    mx /= solidTotal;
    my /= solidTotal;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (int i = 0; i < CELLS; i++) {
      if (solid[i]) {
        double dx = x(i) - mx;
        double dy = y(i) - my;
        xx += mass[i] * dx * dx;
        xy += mass[i] * dx * dy;
        yy += mass[i] * dy * dy;
      }
    }
    double lowX = quantile(marginalX, TAIL);
    double highX = quantile(marginalX, 1 - TAIL);
    double lowY = quantile(marginalY, TAIL);
    double highY = quantile(marginalY, 1 - TAIL);
    middleX = 0.5 * (lowX + highX) * cellPx;
    middleY = 0.5 * (lowY + highY) * cellPx;
    halfX = Math.max(0.5 * (highX - lowX) * cellPx, 1);
    halfY = Math.max(0.5 * (highY - lowY) * cellPx, 1);
    double scale = cellPx * cellPx / solidTotal;
    varianceX = xx * scale;
    covarianceXy = xy * scale;
    varianceY = yy * scale;
  }

  /** Where a marginal reaches a share of its sum, cells from the middle. */
  private double quantile(float[] marginal, double share) {
    double wanted = share * solidTotal;
    double sum = 0;
    for (int i = 0; i < SIDE; i++) {
      double next = sum + marginal[i];
      if (next >= wanted && marginal[i] > 0) {
        return i + (wanted - sum) / marginal[i] - SIDE / 2.0;
      }
      sum = next;
    }
    return SIDE / 2.0;
  }

  /** Half a side of the grid, pixels. */
  double reach() {
    return 0.5 * SIDE * cellPx;
  }

  /** Cell size one step up. */
  double coarser() {
    return cellPx * Math.sqrt(2);
  }

  double size() {
    return 2 * Math.max(halfX, halfY);
  }

  /** Whether it needs another cell size, and which. */
  double wantedCell() {
    double span = size() / cellPx;
    if (span > MAX_SPAN) {
      return cellPx * Math.sqrt(2);
    }
    return span < MIN_SPAN ? Math.max(MIN_CELL_PX, cellPx / Math.sqrt(2)) : cellPx;
  }

  /** Resamples with cells of another size, and the middle of the grid elsewhere. */
  void resample(double cell, double shiftX, double shiftY) {
    System.arraycopy(mass, 0, work, 0, CELLS);
    double from = cellPx;
    Arrays.fill(mass, 0);
    cellPx = cell;
    total = 0;
    for (int i = 0; i < CELLS; i++) {
      if (work[i] > 0) {
        spread(x(i) * from - shiftX, y(i) * from - shiftY, work[i], from);
      }
    }
  }

  /** Adds the weight of a square of a side. */
  void spread(double dx, double dy, double weight, double side) {
    int parts = side > cellPx ? 2 : 1;
    double step = side / parts;
    for (int a = 0; a < parts; a++) {
      for (int b = 0; b < parts; b++) {
        double px = dx + (a + 0.5 - parts / 2.0) * step;
        double py = dy + (b + 0.5 - parts / 2.0) * step;
        bilinear(
            px / cellPx + SIDE / 2.0 - 0.5,
            py / cellPx + SIDE / 2.0 - 0.5,
            weight / (parts * parts));
      }
    }
  }

  private void bilinear(double u, double v, double weight) {
    int c = (int) Math.floor(u);
    int r = (int) Math.floor(v);
    double fu = u - c;
    double fv = v - r;
    put(c, r, weight * (1 - fu) * (1 - fv));
    put(c + 1, r, weight * fu * (1 - fv));
    put(c, r + 1, weight * (1 - fu) * fv);
    put(c + 1, r + 1, weight * fu * fv);
  }

  private void put(int column, int row, double weight) {
    if (column >= 0 && column < SIDE && row >= 0 && row < SIDE) {
      add(row * SIDE + column, weight);
    }
  }

  /** Adds another template that stands elsewhere. */
  void absorb(ShapeTemplate other, double dx, double dy) {
    for (int i = 0; i < CELLS; i++) {
      if (other.mass[i] > 0) {
        spread(dx + x(i) * other.cellPx, dy + y(i) * other.cellPx, other.mass[i], other.cellPx);
      }
    }
  }

  /**
   * Least distance between solid cells of this and another template whose grid stands elsewhere.
   */
  double distance(ShapeTemplate other, double dx, double dy) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < CELLS; i++) {
      if (!core[i] || isInner(i)) {
        continue;
      }
      double px = x(i) * cellPx - dx;
      double py = y(i) * cellPx - dy;
      for (int j = 0; j < CELLS; j++) {
        if (other.core[j]) {
          double qx = px - x(j) * other.cellPx;
          double qy = py - y(j) * other.cellPx;
          least = Math.min(least, qx * qx + qy * qy);
        }
      }
    }
    return Math.max(0, Math.sqrt(least) - 0.5 * (cellPx + other.cellPx));
  }

  private boolean isInner(int i) {
    int c = i % SIDE;
    int r = i / SIDE;
    return c > 0
        && r > 0
        && c < SIDE - 1
        && r < SIDE - 1
        && core[i - 1]
        && core[i + 1]
        && core[i - SIDE]
        && core[i + SIDE];
  }
}
