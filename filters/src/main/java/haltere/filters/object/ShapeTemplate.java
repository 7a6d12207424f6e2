package haltere.filters.object;

import java.util.Arrays;

/**
 * Shape of a component: a grid of cells in its frame with the decaying weight of its events.
 * Smoothed and normalised, it is the spatial density of the events (a histogram estimate:
 * Silverman, Density Estimation, 1986, §2.2); the gradient of its logarithm gives displacements.
 * {@link #refresh} computes the density; weights decay without it. Lengths are in pixels.
 */
final class ShapeTemplate {
  /** Number of cells of a side. */
  static final int SIDE = 24;

  static final int CELLS = SIDE * SIDE;

  /** Smallest side of a cell, pixels. */
  static final double MIN_CELL_PX = 1.5;

  /** Memory of the shape, seconds: limbs and rotations change it within. */
  static final double MEMORY_S = 0.3;

  /** Share of events outside of the present shape, by growth or deformation. */
  private static final double GROWTH = ObjectRelations.ERROR;

  /** Share of the mean density below which a cell is a gap outside of the extent. */
  private static final double FAINT = 0.2;

  /** Largest span of the longer side, cells; the rest is for growth. */
  private static final double MAX_SPAN = 0.8 * SIDE;

  /** Smallest span, cells: two changes of size away. */
  private static final double MIN_SPAN = MAX_SPAN / 2;

  /** Least density, against divergence of the logarithm. */
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

  /** Weight of the events of each cell. */
  final float[] mass = new float[CELLS];

  /** Probability of an event's cell. */
  final float[] density = new float[CELLS];

  /** Derivatives of the logarithm of the density, per pixel. */
  final float[] gradientX = new float[CELLS];

  final float[] gradientY = new float[CELLS];

  /** Its derivative by the angle about the middle of the extent, per radian. */
  final float[] gradientTurn = new float[CELLS];

  private final float[] smooth = new float[CELLS];
  private final float[] wide = new float[CELLS];
  private final float[] work = new float[CELLS];

  /** Copies shifted by one or two cells in both directions. */
  private final float[][] shifted = new float[4][CELLS];

  private final float[] marginalX = new float[SIDE];
  private final float[] marginalY = new float[SIDE];

  /** Side of a cell. */
  double cellPx = MIN_CELL_PX;

  private double perCell = 1 / MIN_CELL_PX;

  /** Weight of the events in the extent, and the least density of its cells. */
  double solidTotal;

  private float faint;

  /** Fisher information of one event about a displacement, per square pixel. */
  double infoXx;

  double infoXy;
  double infoYy;

  /** Fisher information of one event about a rotation, per square radian. */
  double infoTurn;

  /** Middle of the extent's box, from the middle of the grid. */
  double middleX;

  double middleY;

  /** Row of the lower edge, from the middle of the grid. */
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
  }

  private void setCell(double cell) {
    cellPx = cell;
    perCell = 1 / cell;
  }

  /** Scales all lengths; the gradient follows with {@link #refresh}. */
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
    float factor = (float) keep;
    for (int i = 0; i < CELLS; i++) {
      mass[i] *= factor;
    }
  }

  void add(int cell, double weight) {
    mass[cell] += (float) weight;
  }

  /** Three sums at once, as each waits for its last term. */
  static float sum(float[] cells) {
    float a = 0;
    float b = 0;
    float c = 0;
    for (int i = 0; i < CELLS; i += 3) {
      a += cells[i];
      b += cells[i + 1];
      c += cells[i + 2];
    }
    return a + b + c;
  }

  /** Computes the density, its gradient, and the extent. */
  void refresh() {
    blur(mass, work, 1);
    blur(work, smooth, SIDE);
    widen(smooth, work, 1);
    widen(work, wide, SIDE);
    float sum = sum(smooth);
    float scale = sum > 0 ? 1 / sum : 0;
    float own = (float) (1 - GROWTH) * scale;
    float blurred = (float) GROWTH * scale;
    for (int i = 0; i < CELLS; i++) {
      density[i] = own * smooth[i] + blurred * wide[i] + FLOOR;
    }
    differentiate(gradientX, 1);
    differentiate(gradientY, SIDE);
    integrate();
    if (sum > 0) {
      measureExtent();
    }
    turn();
  }

  private void turn() {
    float info = 0;
    for (int i = 0; i < CELLS; i++) {
      float byY = (X[i] * (float) cellPx - (float) middleX) * gradientY[i];
      gradientTurn[i] = byY - (Y[i] * (float) cellPx - (float) middleY) * gradientX[i];
      info += density[i] * gradientTurn[i] * gradientTurn[i];
    }
    infoTurn = info;
  }

  /** A copy shifted by some cells, so that loops are vectorised. */
  private float[] shifted(int copy, float[] from, int by) {
    float[] to = shifted[copy];
    System.arraycopy(from, Math.max(0, by), to, Math.max(0, -by), CELLS - Math.abs(by));
    return to;
  }

  /** Binomial smoothing over three cells some apart; the border of the grid counts as empty. */
  private void blur(float[] from, float[] to, int apart) {
    float[] before = shifted(0, from, -apart);
    float[] after = shifted(1, from, apart);
    for (int i = apart; i < CELLS - apart; i++) {
      to[i] = 0.25f * (before[i] + after[i]) + 0.5f * from[i];
    }
  }

  /** Mean over two cells on each side, the growth within its memory. */
  private void widen(float[] from, float[] to, int apart) {
    float[] second = shifted(0, from, -2 * apart);
    float[] before = shifted(1, from, -apart);
    float[] after = shifted(2, from, apart);
    float[] last = shifted(3, from, 2 * apart);
    for (int i = 2 * apart; i < CELLS - 2 * apart; i++) {
      to[i] = (second[i] + before[i] + from[i] + after[i] + last[i]) / 5;
    }
  }

  /** Differences of the logarithm, bounded at the least density. */
  private void differentiate(float[] to, int apart) {
    float perPx = (float) (1.5 / cellPx);
    float[] low = shifted(0, density, -apart);
    float[] high = shifted(1, density, apart);
    for (int i = SIDE; i < CELLS - SIDE; i++) {
      to[i] = perPx * (high[i] - low[i]) / (high[i] + low[i] + density[i]);
    }
  }

  /** Computes mean and information in one pass, since each sum is slow. */
  private void integrate() {
    float mean = 0;
    float xx = 0;
    float xy = 0;
    float yy = 0;
    for (int i = 0; i < CELLS; i++) {
      float gx = gradientX[i];
      float gy = gradientY[i];
      float weighted = density[i] * gx;
      mean += density[i] * density[i];
      xx += weighted * gx;
      xy += weighted * gy;
      yy += density[i] * gy * gy;
    }
    faint = (float) FAINT * mean;
    infoXx = xx;
    infoXy = xy;
    infoYy = yy;
  }

  /** Whether a cell is part of the extent. */
  boolean isCore(int cell) {
    return density[cell] > faint;
  }

  private void measureExtent() {
    for (int i = 0; i < CELLS; i++) {
      work[i] = isCore(i) ? mass[i] : 0;
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

  /** Quantile of a marginal, cells from the middle. */
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
   * First cell with half of the weighted mean of a marginal, from the middle of the grid: the
   * position of a symmetrically blurred edge.
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

  /** Cell size for the present extent; cells that shrank with it are kept for a step. */
  double wantedCell() {
    double span = size() * perCell;
    if (span > MAX_SPAN) {
      return coarser();
    }
    double finest = coarser() > MIN_CELL_PX ? Math.min(cellPx, MIN_CELL_PX) : MIN_CELL_PX;
    return Math.max(finest, span < MIN_SPAN ? cellPx / Math.sqrt(2) : cellPx);
  }

  /** Resamples with another cell size and another middle of the grid. */
  void resample(double cell, double shiftX, double shiftY) {
    System.arraycopy(mass, 0, work, 0, CELLS);
    double from = cellPx;
    clear(cell);
    spread(work, from, -shiftX, -shiftY);
  }

  /** Adds the weights of another template at an offset. */
  void spread(float[] weights, double side, double dx, double dy) {
    for (int i = 0; i < CELLS; i++) {
      if (weights[i] > 0) {
        spread(X[i] * side + dx, Y[i] * side + dy, weights[i], side);
      }
    }
  }

  /** Adds the weight of a square. */
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

  /** Distributes a weight to four cells, bilinearly. */
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
