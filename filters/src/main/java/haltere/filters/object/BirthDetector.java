package haltere.filters.object;

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
  /**
   * Evidence of a birth, nat. A picture has up to 14,400 cells and looks 20 times a second: 12 nat
   * are one false birth in two seconds of such noise, which novelty then refuses.
   */
  private static final double BIRTH_NAT = 12;

  /** Evidence with which a cell belongs to a birth, nat: odds of 7. */
  private static final double CELL_NAT = 2;

  /** Standard deviation of a velocity before it was measured, sizes per second. */
  static final double SPEED_SIZES_S = 5;

  /** Events from which a place and a velocity can be estimated. */
  private static final int MIN_EVENTS = 6;

  private static final int RING = 1 << 15;
  private static final int WINDOW = (int) Math.round(2 * ClutterMap.BIRTH_S / ObjectTracker.TICK_S);

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

  /** Sums of the events of a birth. */
  private static final class Cloud {
    double n;
    double x;
    double y;
    double t;
    double xx;
    double yy;
    double tt;
    double xt;
    double yt;

    void add(double px, double py, double s) {
      n++;
      x += px;
      y += py;
      t += s;
      xx += px * px;
      yy += py * py;
      tt += s * s;
      xt += px * s;
      yt += py * s;
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
    boolean isClean = true;
    for (int cell = 0; cell < seen.length; cell++) {
      if (!isSurprising(cell)) {
        continue;
      }
      if (isClean) {
        Arrays.fill(seen, false);
        isClean = false;
      }
      if (!seen[cell]) {
        int size = connect(cell);
        double total = 0;
        for (int i = 0; i < size; i++) {
          total += clutter.surprise(stack[i]);
        }
        if (total >= BIRTH_NAT) {
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

  /** Makes a component of the events in cells, or says that there are too few. */
  boolean begin(int[] cells, Component component) {
    Arrays.fill(mine, false);
    for (int cell : cells) {
      mine[cell] = true;
      clutter.clear(cell);
    }
    Cloud cloud = new Cloud();
    visit(cloud::add, false);
    if (cloud.n < MIN_EVENTS) {
      return false;
    }
    place(cloud, component);
    double x = component.x();
    double y = component.y();
    double vx = component.vx();
    double vy = component.vy();
    visit((px, py, s) -> component.shape.spread(px - x - vx * s, py - y - vy * s, 1, 1), true);
    component.rate = cloud.n / WINDOW;
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

  /** Linear regression of place on time, with a prior of the velocity. */
  private static void place(Cloud cloud, Component component) {
    double n = cloud.n;
    double mx = cloud.x / n;
    double my = cloud.y / n;
    double mt = cloud.t / n;
    double vxx = cloud.xx / n - mx * mx;
    double vyy = cloud.yy / n - my * my;
    double dt = ObjectTracker.TICK_S;
    double vtt = Math.max(cloud.tt / n - mt * mt, dt * dt / 12);
    double half = Math.max(2, 2 * Math.sqrt(Math.max(vxx, vyy)));
    double prior = SPEED_SIZES_S * 2 * half;
    double r = Math.max(0.25 * (vxx + vyy), 1);
    double keep = prior * prior / (prior * prior + r / (n * vtt));
    double vx = keep * (cloud.xt / n - mx * mt) / vtt;
    double vy = keep * (cloud.yt / n - my * mt) / vtt;
    double pv = (1 - keep) * prior * prior + 1;
    double pp = r / n + pv * mt * mt;
    component.state.setMean(0, mx - vx * mt);
    component.state.setMean(1, vx);
    component.state.setMean(2, my - vy * mt);
    component.state.setMean(3, vy);
    component.state.setVariances(pp, pv, pp, pv);
    component.state.addNoise(0, 1, -pv * mt);
    component.state.addNoise(2, 3, -pv * mt);
    component.shape.clear(
        Math.max(ShapeTemplate.MIN_CELL_PX, 2 * half / (0.5 * ShapeTemplate.SIDE)));
  }
}
