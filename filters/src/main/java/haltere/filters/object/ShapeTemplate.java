package haltere.filters.object;

import java.util.Arrays;

/**
 * Where on a component its events come from: a grid of cells that moves with it and holds the
 * decaying weight of its events. Smoothed and normalised it is the spatial density of the events (a
 * histogram estimate: Silverman, Density Estimation, 1986, §2.2); the gradient of its logarithm
 * tells a displacement.
 *
 * <p>The density is worked out anew by {@link #refresh}; weights decay without it.
 *
 * <p>Pixels. Thread rule: one thread at a time.
 */
final class ShapeTemplate {
  /** Cells of a side. */
  static final int SIDE = 24;

  static final int CELLS = SIDE * SIDE;

  /** Least side of a cell, pixels: sub-pixel detail is not seen. */
  static final double MIN_CELL_PX = 1.5;

  /** Memory of the shape, seconds: limbs and turns change it within. */
  static final double MEMORY_S = 0.3;

  /** Share of the events that come from beside the shape seen so far: it grows or bends. */
  private static final double GROWTH = 0.05;

  /** Cells up to which it may grow within its memory. */
  private static final int GROWTH_CELLS = 2;

  /** Share of the mean density below which a cell does not belong to the extent. */
  private static final double FAINT = 0.1;

  /** Share of the mean density below which a cell does not connect two others. */
  private static final double SPARSE = 0.3;

  /** Share of the events beyond either side of the extent: two standard deviations. */
  static final double TAIL = 0.02;

  /** Share of the usual weight of a row at an edge. */
  private static final double EDGE = 0.5;

  /** Cells that the longer side spans: between both, the cells keep their size. */
  private static final double MIN_SPAN = 0.5 * SIDE;

  private static final double MAX_SPAN = 0.8 * SIDE;

  /** Probability that an event is anywhere in the grid, so that no logarithm diverges. */
  private static final float FLOOR = 1e-3f / CELLS;

  private static final double HALF = SIDE / 2.0;
  private static final float[] X = new float[CELLS];
  private static final float[] Y = new float[CELLS];

  static {
    for (int i = 0; i < CELLS; i++) {
      X[i] = (float) ((i % SIDE) + 0.5 - HALF);
      Y[i] = (float) ((i / SIDE) + 0.5 - HALF);
    }
  }

  /** Weight of the events of each cell, as of {@link #settle}. */
  final float[] mass = new float[CELLS];

  /** Probability of an event's cell. */
  final float[] density = new float[CELLS];

  /** Derivatives of the logarithm of the density, per pixel. */
  final float[] gradientX = new float[CELLS];

  final float[] gradientY = new float[CELLS];

  /** Cells that connect: those of the extent that are not sparse. */
  final boolean[] core = new boolean[CELLS];

  private final float[] smooth = new float[CELLS];
  private final float[] wide = new float[CELLS];
  private final float[] work = new float[CELLS];
  private final float[] marginalX = new float[SIDE];
  private final float[] marginalY = new float[SIDE];

  /** Side of a cell. */
  double cellPx = MIN_CELL_PX;

  private double perCell = 1 / MIN_CELL_PX;
  private float fade = 1;
  private float perFade = 1;

  /** Weight of all events, and of those in the extent. */
  double total;

  double solidTotal;

  /** Fisher information of one event about a displacement, per square pixel. */
  double infoXx;

  double infoXy;
  double infoYy;

  /** Middle of the extent's box, from the middle of the grid. */
  double middleX;

  double middleY;

  /** Row of the lower edge, from the middle of the grid: half the usual events of a row. */
  double lowEdge;

  /** Half sides of the box. */
  double halfX;

  double halfY;

  /** Covariance of the extent's events, px². */
  double varianceX;

  double covarianceXy;
  double varianceY;

  void clear(double cell) {
    Arrays.fill(mass, 0);
    setCell(cell);
    total = 0;
    fade = 1;
    perFade = 1;
  }

  private void setCell(double cell) {
    cellPx = cell;
    perCell = 1 / cell;
  }

  /** Scales all lengths, as of what comes nearer; the gradient follows with {@link #refresh}. */
  void grow(double factor) {
    setCell(cellPx * factor);
    middleX *= factor;
    middleY *= factor;
    halfX *= factor;
    halfY *= factor;
    lowEdge *= factor;
  }

  /** Column of a cell's middle from the middle of the grid, cells. */
  static double x(int cell) {
    return X[cell];
  }

  static double y(int cell) {
    return Y[cell];
  }

  /** Half a side of the grid. */
  double reach() {
    return HALF * cellPx;
  }

  /** Longer side of the extent's box. */
  double size() {
    return 2 * Math.max(halfX, halfY);
  }

  /** Cell of an offset from the middle of the grid; -1 outside. */
  int cell(double dx, double dy) {
    double column = dx * perCell + HALF;
    double row = dy * perCell + HALF;
    return column >= 0 && column < SIDE && row >= 0 && row < SIDE
        ? (int) row * SIDE + (int) column
        : -1;
  }

  void decay(double keep) {
    fade *= (float) keep;
    perFade = 1 / fade;
  }

  void add(int cell, double weight) {
    mass[cell] += (float) weight * perFade;
  }

  /** Brings the weights to now. */
  void settle() {
    float sum = 0;
    for (int i = 0; i < CELLS; i++) {
      mass[i] *= fade;
      sum += mass[i];
    }
    total = sum;
    fade = 1;
    perFade = 1;
  }

  /** Works out the density, its gradient, and the extent. */
  void refresh() {
    settle();
    blur();
    widen();
    float sum = 0;
    for (int i = 0; i < CELLS; i++) {
      sum += smooth[i];
    }
    float scale = sum > 0 ? 1 / sum : 0;
    float own = (float) (1 - GROWTH) * scale;
    float grown = (float) GROWTH * scale;
    for (int i = 0; i < CELLS; i++) {
      density[i] = own * smooth[i] + grown * wide[i] + FLOOR;
    }
    differentiate();
    measureExtent();
  }

  /** Binomial smoothing over three cells each way; the border of the grid counts as empty. */
  private void blur() {
    for (int i = 1; i < CELLS - 1; i++) {
      work[i] = 0.25f * (mass[i - 1] + mass[i + 1]) + 0.5f * mass[i];
    }
    for (int i = SIDE; i < CELLS - SIDE; i++) {
      smooth[i] = 0.25f * (work[i - SIDE] + work[i + SIDE]) + 0.5f * work[i];
    }
  }

  /** The smoothed weight spread over squares of 2 GROWTH_CELLS + 1 cells. */
  private void widen() {
    float share = 1f / (2 * GROWTH_CELLS + 1);
    for (int i = GROWTH_CELLS; i < CELLS - GROWTH_CELLS; i++) {
      work[i] = share * (smooth[i - 2] + smooth[i - 1] + smooth[i] + smooth[i + 1] + smooth[i + 2]);
    }
    int step = SIDE;
    for (int i = GROWTH_CELLS * step; i < CELLS - GROWTH_CELLS * step; i++) {
      wide[i] =
          share
              * (work[i - 2 * step]
                  + work[i - step]
                  + work[i]
                  + work[i + step]
                  + work[i + 2 * step]);
    }
  }

  /** Differences of the logarithm, bounded where the density is the floor. */
  private void differentiate() {
    float perPx = (float) (1.5 / cellPx);
    for (int i = SIDE; i < CELLS - SIDE; i++) {
      float left = density[i - 1];
      float right = density[i + 1];
      float below = density[i - SIDE];
      float above = density[i + SIDE];
      gradientX[i] = perPx * (right - left) / (right + left + density[i]);
      gradientY[i] = perPx * (above - below) / (above + below + density[i]);
    }
    float xx = 0;
    float xy = 0;
    float yy = 0;
    for (int i = SIDE; i < CELLS - SIDE; i++) {
      float gx = gradientX[i];
      float gy = gradientY[i];
      float weighted = density[i] * gx;
      xx += weighted * gx;
      xy += weighted * gy;
      yy += density[i] * gy * gy;
    }
    infoXx = xx;
    infoXy = xy;
    infoYy = yy;
  }

  private void measureExtent() {
    if (!(total > 0)) {
      return;
    }
    float mean = 0;
    for (int i = 0; i < CELLS; i++) {
      mean += density[i] * density[i];
    }
    float faint = (float) FAINT * mean;
    float sparse = (float) SPARSE * mean;
    for (int i = 0; i < CELLS; i++) {
      core[i] = density[i] > sparse;
      work[i] = density[i] > faint ? mass[i] : 0;
    }
    Arrays.fill(marginalX, 0);
    double xy = 0;
    for (int row = 0; row < SIDE; row++) {
      float inRow = 0;
      float alongRow = 0;
      for (int column = 0; column < SIDE; column++) {
        float m = work[row * SIDE + column];
        marginalX[column] += m;
        inRow += m;
        alongRow += m * X[column];
      }
      marginalY[row] = inRow;
      xy += alongRow * X[row];
    }
    double mx = 0;
    double my = 0;
    double xx = 0;
    double yy = 0;
    solidTotal = 0;
    for (int i = 0; i < SIDE; i++) {
      solidTotal += marginalY[i];
      mx += marginalX[i] * X[i];
      my += marginalY[i] * X[i];
      xx += marginalX[i] * X[i] * X[i];
      yy += marginalY[i] * X[i] * X[i];
    }
    if (!(solidTotal > 0)) {
      return;
    }
    mx /= solidTotal;
    my /= solidTotal;
    double area = cellPx * cellPx;
    varianceX = (xx / solidTotal - mx * mx) * area;
    covarianceXy = (xy / solidTotal - mx * my) * area;
    varianceY = (yy / solidTotal - my * my) * area;
    double lowX = quantile(marginalX, TAIL);
    double highX = quantile(marginalX, 1 - TAIL);
    double lowY = quantile(marginalY, TAIL);
    double highY = quantile(marginalY, 1 - TAIL);
    middleX = 0.5 * (lowX + highX) * cellPx;
    middleY = 0.5 * (lowY + highY) * cellPx;
    halfX = Math.max(0.5 * (highX - lowX) * cellPx, 1);
    halfY = Math.max(0.5 * (highY - lowY) * cellPx, 1);
    lowEdge = firstAt(marginalY, EDGE) * cellPx;
  }

  /** Where a marginal reaches a share of its sum, cells from the middle. */
  private double quantile(float[] marginal, double share) {
    double wanted = share * solidTotal;
    double sum = 0;
    for (int i = 0; i < SIDE; i++) {
      double next = sum + marginal[i];
      if (next >= wanted && marginal[i] > 0) {
        return i + (wanted - sum) / marginal[i] - HALF;
      }
      sum = next;
    }
    return HALF;
  }

  /**
   * Where a marginal first reaches a share of its mean by weight, cells from the middle of the
   * grid. An edge that is blurred symmetrically has half of it at its place.
   */
  private static double firstAt(float[] marginal, double share) {
    double sum = 0;
    double squares = 0;
    for (float m : marginal) {
      sum += m;
      squares += m * (double) m;
    }
    double level = share * squares / sum;
    int i = 0;
    while (marginal[i] < level) {
      i++;
    }
    double before = i == 0 ? 0 : marginal[i - 1];
    return X[i] - (marginal[i] - level) / (marginal[i] - before);
  }

  /** Cell size one step up. */
  double coarser() {
    return cellPx * Math.sqrt(2);
  }

  /** The cell size that fits its extent. */
  double wantedCell() {
    double span = size() * perCell;
    if (span > MAX_SPAN) {
      return coarser();
    }
    return Math.max(MIN_CELL_PX, span < MIN_SPAN ? cellPx / Math.sqrt(2) : cellPx);
  }

  /** Resamples with cells of another size, and the middle of the grid elsewhere. */
  void resample(double cell, double shiftX, double shiftY) {
    settle();
    System.arraycopy(mass, 0, work, 0, CELLS);
    double from = cellPx;
    clear(cell);
    for (int i = 0; i < CELLS; i++) {
      if (work[i] > 0) {
        spread(X[i] * from - shiftX, Y[i] * from - shiftY, work[i], from);
      }
    }
  }

  /** Adds another template that stands elsewhere. */
  void absorb(ShapeTemplate other, double dx, double dy) {
    settle();
    other.settle();
    for (int i = 0; i < CELLS; i++) {
      if (other.mass[i] > 0) {
        spread(dx + X[i] * other.cellPx, dy + Y[i] * other.cellPx, other.mass[i], other.cellPx);
      }
    }
  }

  /** Adds the weight of a square of a side. */
  void spread(double dx, double dy, double weight, double side) {
    int parts = side > cellPx ? 2 : 1;
    double step = side / parts;
    for (int a = 0; a < parts; a++) {
      for (int b = 0; b < parts; b++) {
        double x = dx + (a + 0.5 - parts / 2.0) * step;
        double y = dy + (b + 0.5 - parts / 2.0) * step;
        addBetween(x * perCell + HALF - 0.5, y * perCell + HALF - 0.5, weight / (parts * parts));
      }
    }
  }

  /** Shares a weight among four cells, bilinearly. */
  private void addBetween(double column, double row, double weight) {
    int c = (int) Math.floor(column);
    int r = (int) Math.floor(row);
    double right = column - c;
    double above = row - r;
    put(c, r, weight * (1 - right) * (1 - above));
    put(c + 1, r, weight * right * (1 - above));
    put(c, r + 1, weight * (1 - right) * above);
    put(c + 1, r + 1, weight * right * above);
  }

  private void put(int column, int row, double weight) {
    if (column >= 0 && column < SIDE && row >= 0 && row < SIDE) {
      add(row * SIDE + column, weight);
    }
  }
}
