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
  private static final double GROWTH = ObjectRelations.ERROR;

  /** Cells up to which it may grow within its memory. */
  private static final int GROWTH_CELLS = 2;

  /** Share of the mean density below which a cell is a gap, and not of the extent. */
  private static final double FAINT = 0.2;

  /** Cells that the longer side spans at most: the rest is for growth. */
  private static final double MAX_SPAN = 0.8 * SIDE;

  /** Cells that it spans at least: two changes of size away. */
  private static final double MIN_SPAN = MAX_SPAN / 2;

  /** Probability that an event is anywhere in the grid, so that no logarithm diverges. */
  private static final float FLOOR = 1e-3f / CELLS;

  private static final double HALF = SIDE / 2.0;

  /** Columns and rows of the cells' middles from the middle of the grid, cells. */
  static final float[] X = new float[CELLS];

  static final float[] Y = new float[CELLS];

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

  /** Cells of the extent. */
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
    widen(smooth, work, 1);
    widen(work, wide, SIDE);
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

  /** The mean of a cell and of those to both sides of it, some cells apart in the arrays. */
  private static void widen(float[] from, float[] to, int apart) {
    int reach = GROWTH_CELLS * apart;
    for (int i = reach; i < CELLS - reach; i++) {
      float sum = 0;
      for (int k = i - reach; k <= i + reach; k += apart) {
        sum += from[k];
      }
      to[i] = sum / (2 * GROWTH_CELLS + 1);
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
    for (int i = 0; i < CELLS; i++) {
      core[i] = density[i] > faint;
      work[i] = core[i] ? mass[i] : 0;
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
    // events are evenly spread within a cell
    varianceX = (xx / solidTotal - mx * mx + 1.0 / 12) * area;
    covarianceXy = (xy / solidTotal - mx * my) * area;
    varianceY = (yy / solidTotal - my * my + 1.0 / 12) * area;
    double lowX = quantile(marginalX, ObjectRelations.ERROR / 2);
    double highX = quantile(marginalX, 1 - ObjectRelations.ERROR / 2);
    double lowY = quantile(marginalY, ObjectRelations.ERROR / 2);
    double highY = quantile(marginalY, 1 - ObjectRelations.ERROR / 2);
    middleX = 0.5 * (lowX + highX) * cellPx;
    middleY = 0.5 * (lowY + highY) * cellPx;
    halfX = Math.max(0.5 * (highX - lowX) * cellPx, 1);
    halfY = Math.max(0.5 * (highY - lowY) * cellPx, 1);
    lowEdge = edge(marginalY) * cellPx;
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
   * Where a marginal first reaches half of its mean by weight, cells from the middle of the grid.
   * An edge that is blurred symmetrically has half of it at its place.
   */
  private static double edge(float[] marginal) {
    double sum = 0;
    double squares = 0;
    for (float m : marginal) {
      sum += m;
      squares += m * (double) m;
    }
    double level = 0.5 * squares / sum;
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
    spread(work, from, -shiftX, -shiftY);
  }

  /** Adds another template that stands elsewhere. */
  void absorb(ShapeTemplate other, double dx, double dy) {
    settle();
    other.settle();
    spread(other.mass, other.cellPx, dx, dy);
  }

  private void spread(float[] weights, double side, double dx, double dy) {
    for (int i = 0; i < CELLS; i++) {
      if (weights[i] > 0) {
        spread(X[i] * side + dx, Y[i] * side + dy, weights[i], side);
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
