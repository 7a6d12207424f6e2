package haltere.filters.object;

import haltere.filters.estimation.GaussianState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds new components: connected cells in which much more came within 50 ms than clutter explains.
 * Their events are kept for as long, so that a new component begins with a shape, a place and, by
 * linear regression with a prior, a velocity.
 *
 * <p>Thread rule: one thread at a time.
 */
final class BirthDetector {
  /** Evidence with which a cell belongs to a birth, nat: odds of 7. */
  private static final double CELL_NAT = 2;

  /** Standard deviation of a velocity before it was measured, sizes per second. */
  static final double SPEED_SIZES_S = 5;

  private static final int RING = 1 << 15;

  /** Ticks of the events that make a component: 86 % of an exponential memory. */
  static final int WINDOW = (int) Math.round(2 * ClutterMap.BIRTH_S / ObjectTracker.TICK_S);

  private final ActivityGrid grid;
  private final ClutterMap clutter;
  private final int[] ringTile = new int[RING];
  private final int[] ringPixels = new int[RING];
  private final int[] ringTick = new int[RING];
  private final int[] stack;
  private final boolean[] seen;
  private final boolean[] mine;
  private final List<int[]> found = new ArrayList<>();
  private long remembered;
  private int tick;

  /** Takes an event; its time in seconds before now, at most 0. */
  private interface Visitor {
    void event(double x, double y, double s);
  }

  /** Sums of one coordinate z of the events of a birth, and of their times t. */
  private static final class Axis {
    double n;
    double z;
    double t;
    double zz;
    double tt;
    double zt;

    void add(double place, double s) {
      n++;
      z += place;
      t += s;
      zz += place * place;
      tt += s * s;
      zt += place * s;
    }

    double variance() {
      return (zz - z * z / n) / n;
    }

    /** Linear regression of places of a variance r on time, with a prior of the velocity. */
    void start(GaussianState state, int at, double r, double priorSd) {
      double prior = priorSd * priorSd;
      double vtt = Math.max((tt - t * t / n) / n, ObjectTracker.TICK_S * ObjectTracker.TICK_S / 12);
      double keep = prior / (prior + r / (n * vtt));
      double v = keep * (zt - z * t / n) / (n * vtt);
      double pv = (1 - keep) * prior + 1;
      double meanT = t / n;
      state.setMean(at, z / n - v * meanT);
      state.setMean(at + 1, v);
      state.addNoise(at, r / n + pv * meanT * meanT);
      state.addNoise(at + 1, pv);
      state.addNoise(at, at + 1, -pv * meanT);
    }
  }

  BirthDetector(ActivityGrid grid, ClutterMap clutter) {
    this.grid = grid;
    this.clutter = clutter;
    stack = new int[clutter.cells()];
    seen = new boolean[clutter.cells()];
    mine = new boolean[clutter.cells()];
  }

  void begin(int passed) {
    tick += passed;
  }

  void reset() {
    remembered = 0;
  }

  /** Keeps the pixels of a tile that nothing explains. */
  void remember(int tile, int pixels) {
    int i = (int) (remembered++ & RING - 1);
    ringTile[i] = tile;
    ringPixels[i] = pixels;
    ringTick[i] = tick;
  }

  /** Cells of each birth of this tick; the list is used again. */
  List<int[]> find() {
    found.clear();
    Arrays.fill(seen, false);
    for (int cell = 0; cell < seen.length; cell++) {
      if (isSurprising(cell) && !seen[cell]) {
        int size = connect(cell);
        double total = 0;
        for (int i = 0; i < size; i++) {
          total += clutter.surprise(stack[i]);
        }
        // a component costs nothing but time: its motion is to bring the other half
        if (total >= 0.5 * clutter.alarmNat()) {
          found.add(Arrays.copyOf(stack, size));
        }
      }
    }
    return found;
  }

  private boolean isSurprising(int cell) {
    return clutter.maySurprise(cell, CELL_NAT) && clutter.surprise(cell) >= CELL_NAT;
  }

  private int connect(int start) {
    int size = 0;
    stack[size++] = start;
    seen[start] = true;
    for (int at = 0; at < size; at++) {
      int column = stack[at] % clutter.columns;
      int row = stack[at] / clutter.columns;
      for (int r = Math.max(0, row - 1); r <= Math.min(clutter.rows - 1, row + 1); r++) {
        for (int c = Math.max(0, column - 1); c <= Math.min(clutter.columns - 1, column + 1); c++) {
          int next = r * clutter.columns + c;
          if (!seen[next] && isSurprising(next)) {
            seen[next] = true;
            stack[size++] = next;
          }
        }
      }
    }
    return size;
  }

  /** Makes a component of the events in cells, or says that there are none. */
  boolean begin(int[] cells, Component component) {
    Arrays.fill(mine, false);
    for (int cell : cells) {
      mine[cell] = true;
      clutter.clear(cell);
    }
    Axis alongX = new Axis();
    Axis alongY = new Axis();
    visit(
        (px, py, t) -> {
          alongX.add(px, t);
          alongY.add(py, t);
        },
        false);
    if (alongX.n == 0) {
      return false;
    }
    double xx = alongX.variance();
    double yy = alongY.variance();
    double size = Math.max(4, 4 * Math.sqrt(Math.max(xx, yy)));
    double r = Math.max(0.25 * (xx + yy), 1);
    component.state.setVariances(0, 0, 0, 0);
    alongX.start(component.state, 0, r, SPEED_SIZES_S * size);
    alongY.start(component.state, 2, r, SPEED_SIZES_S * size);
    component.shape.clear(Math.max(ShapeTemplate.MIN_CELL_PX, size / (0.5 * ShapeTemplate.SIDE)));
    double x = component.x();
    double y = component.y();
    double vx = component.vx();
    double vy = component.vy();
    visit((px, py, s) -> component.shape.spread(px - x - vx * s, py - y - vy * s, 1, 1), true);
    component.rate = alongX.n / WINDOW;
    component.shape.refresh();
    return true;
  }

  /** Visits the events that are kept of the birth, and forgets them the last time. */
  private void visit(Visitor visitor, boolean last) {
    long first = Math.max(0, remembered - RING);
    for (long i = remembered - 1; i >= first; i--) {
      int at = (int) (i & RING - 1);
      if (tick - ringTick[at] > WINDOW) {
        return;
      }
      int tile = ringTile[at];
      int x = grid.x(tile);
      int y = grid.y(tile);
      if (!mine[clutter.cellAt(x, y)]) {
        continue;
      }
      double s = (ringTick[at] - tick) * ObjectTracker.TICK_S;
      for (int left = ringPixels[at]; left != 0; left &= left - 1) {
        int pixel = Integer.numberOfTrailingZeros(left);
        visitor.event(x + ActivityGrid.pixelX(pixel), y + ActivityGrid.pixelY(pixel), s);
      }
      if (last) {
        ringPixels[at] = 0;
      }
    }
  }
}
