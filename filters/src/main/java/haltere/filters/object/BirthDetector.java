package haltere.filters.object;

import haltere.filters.estimation.GaussianState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Detects new components: connected cells with far more events within 50 ms than clutter explains.
 * These events are stored, so that a new component starts with a shape, a position and, by linear
 * regression with a prior, a velocity.
 */
final class BirthDetector {
  /** Least evidence of a cell of a birth, nat: odds of 7. */
  private static final double CELL_NAT = 2;

  /** Prior standard deviation of a velocity, sizes per second. */
  static final double SPEED_SIZES_S = 5;

  private static final int RING = 1 << 15;

  /** Ticks of the events of a new component: 86 % of an exponential memory. */
  static final int WINDOW = (int) Math.round(2 * ClutterMap.BIRTH_S / ObjectTracker.TICK_S);

  private final ActivityGrid grid;
  private final ClutterMap clutter;
  private final int[] ringTile = new int[RING];
  private final int[] ringPixels = new int[RING];
  private final int[] ringTick = new int[RING];

  /** The previously stored tile of the same cell. */
  private final long[] ringBefore = new long[RING];

  /** For each cell, the number of tiles stored up to its own last one. */
  private final long[] latest;

  private final int[] changed;
  private final int[] stack;
  private final boolean[] seen;
  private final List<int[]> found = new ArrayList<>();

  /** Events of a birth: positions, and times in seconds before now, at most 0. */
  private double[] eventX = new double[1024];

  private double[] eventY = new double[1024];
  private double[] eventS = new double[1024];
  private int events;
  private long remembered;
  private int changedCells;
  private double excessNat;
  private int tick;

  BirthDetector(ActivityGrid grid, ClutterMap clutter) {
    this.grid = grid;
    this.clutter = clutter;
    stack = new int[clutter.cells];
    seen = new boolean[clutter.cells];
    latest = new long[clutter.cells];
    changed = new int[clutter.cells];
  }

  void begin(int passed) {
    tick += passed;
    changedCells = 0;
    Arrays.fill(seen, false);
  }

  void reset() {
    remembered = 0;
    Arrays.fill(latest, 0);
  }

  /** Notes the cell of a tile with events for {@link #find}, and stores its unexplained pixels. */
  void remember(int tile, int cell, int pixels) {
    if (!seen[cell]) {
      seen[cell] = true;
      changed[changedCells++] = cell;
    }
    if (pixels == 0) {
      return;
    }
    int i = (int) (remembered++ & RING - 1);
    ringBefore[i] = latest[cell];
    latest[cell] = remembered;
    ringTile[i] = tile;
    ringPixels[i] = pixels;
    ringTick[i] = tick;
  }

  /** Cells of each birth of this tick, next to events of it; the list is reused. */
  List<int[]> find() {
    found.clear();
    Arrays.fill(seen, false);
    for (int k = 0; k < changedCells; k++) {
      if (!seen[changed[k]] && clutter.isExcess(changed[k], CELL_NAT)) {
        int size = connect(changed[k]);
        // a component costs nothing but time: its motion is to bring the other half
        if (excessNat >= 0.5 * clutter.alarmNat()) {
          found.add(Arrays.copyOf(stack, size));
        }
      }
    }
    return found;
  }

  /** Lists the cells connected with one, and sums their log ratios; returns their number. */
  private int connect(int start) {
    int size = 0;
    excessNat = 0;
    stack[size++] = start;
    seen[start] = true;
    for (int at = 0; at < size; at++) {
      excessNat += clutter.logRatio(stack[at]);
      int column = stack[at] % clutter.columns;
      int row = stack[at] / clutter.columns;
      for (int r = Math.max(0, row - 1); r <= Math.min(clutter.rows - 1, row + 1); r++) {
        for (int c = Math.max(0, column - 1); c <= Math.min(clutter.columns - 1, column + 1); c++) {
          int next = r * clutter.columns + c;
          if (!seen[next] && clutter.isExcess(next, CELL_NAT)) {
            seen[next] = true;
            stack[size++] = next;
          }
        }
      }
    }
    return size;
  }

  /** Initialises a component from the events in cells; false if there are none. */
  boolean begin(int[] cells, Component component) {
    collect(cells);
    if (events == 0) {
      return false;
    }
    double xx = covariance(eventX, eventX);
    double yy = covariance(eventY, eventY);
    double size = Math.max(4, 4 * Math.sqrt(Math.max(xx, yy)));
    double r = Math.max(0.25 * (xx + yy), 1);
    component.state.setVariances(0, 0, 0, 0);
    start(component.state, 0, eventX, r, SPEED_SIZES_S * size);
    start(component.state, 2, eventY, r, SPEED_SIZES_S * size);
    component.shape.clear(Math.max(ShapeTemplate.MIN_CELL_PX, size / (0.5 * ShapeTemplate.SIDE)));
    for (int i = 0; i < events; i++) {
      double dx = eventX[i] - component.x() - component.vx() * eventS[i];
      double dy = eventY[i] - component.y() - component.vy() * eventS[i];
      component.shape.spread(dx, dy, 1, 1);
    }
    component.rate = (double) events / WINDOW;
    component.shape.refresh();
    return true;
  }

  private double mean(double[] values) {
    double sum = 0;
    for (int i = 0; i < events; i++) {
      sum += values[i];
    }
    return sum / events;
  }

  private double covariance(double[] a, double[] b) {
    double meanA = mean(a);
    double meanB = mean(b);
    double sum = 0;
    for (int i = 0; i < events; i++) {
      sum += (a[i] - meanA) * (b[i] - meanB);
    }
    return sum / events;
  }

  /** Linear regression of positions with the variance r over time, with a prior of the velocity. */
  private void start(GaussianState state, int at, double[] z, double r, double priorSd) {
    double prior = priorSd * priorSd;
    double tick = ObjectTracker.TICK_S;
    double variance = Math.max(covariance(eventS, eventS), tick * tick / 12);
    double keep = prior / (prior + r / (events * variance));
    double v = keep * covariance(z, eventS) / variance;
    double pv = (1 - keep) * prior + 1;
    double meanS = mean(eventS);
    state.setMean(at, mean(z) - v * meanS);
    state.setMean(at + 1, v);
    state.addNoise(at, r / events + pv * meanS * meanS);
    state.addNoise(at + 1, pv);
    state.addNoise(at, at + 1, -pv * meanS);
  }

  /** Collects the stored events of some cells. */
  private void collect(int[] cells) {
    events = 0;
    long last = Math.max(0, remembered - RING);
    for (int cell : cells) {
      for (long i = latest[cell]; i > last; i = ringBefore[(int) (i - 1 & RING - 1)]) {
        int at = (int) (i - 1 & RING - 1);
        if (tick - ringTick[at] > WINDOW) {
          break;
        }
        int x = grid.x(ringTile[at]);
        int y = grid.y(ringTile[at]);
        for (int left = ringPixels[at]; left != 0; left &= left - 1) {
          int pixel = Integer.numberOfTrailingZeros(left);
          add(x + ActivityGrid.pixelX(pixel), y + ActivityGrid.pixelY(pixel), ringTick[at] - tick);
        }
      }
      latest[cell] = 0;
      clutter.clear(cell);
    }
  }

  private void add(int x, int y, int ticks) {
    if (events == eventX.length) {
      eventX = Arrays.copyOf(eventX, 2 * events);
      eventY = Arrays.copyOf(eventY, 2 * events);
      eventS = Arrays.copyOf(eventS, 2 * events);
    }
    eventX[events] = x;
    eventY[events] = y;
    eventS[events++] = ticks * ObjectTracker.TICK_S;
  }
}
