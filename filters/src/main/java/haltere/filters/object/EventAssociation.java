package haltere.filters.object;

import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.List;

/**
 * Shares the events of a tick among the components and clutter. Events are a Poisson process of
 * clutter and components (Streit, Poisson Point Processes, 2010, §3.2): an event is a component's
 * with the probability λ<sub>k</sub> / Σ λ at its pixel and its own time, the expectation step of
 * Dempster, Laird and Rubin (1977).
 *
 * <p>Thread rule: one thread at a time.
 */
final class EventAssociation {
  private static final int BLOCK_SHIFT = 4;

  /** Components that share a block of 16 × 16 pixels; more do not count there. */
  private static final int MAX_NEAR = 16;

  private final ActivityGrid grid;
  private final ClutterMap clutter;
  private final BirthDetector births;
  private final int columns;
  private final int rows;
  private final int[] head;
  private int[] next = new int[1024];
  private Component[] entry = new Component[1024];
  private int entries;
  private final Component[] near = new Component[MAX_NEAR];
  private final double[] nearX = new double[MAX_NEAR];
  private final double[] nearY = new double[MAX_NEAR];
  private final double[] intensity = new double[MAX_NEAR];
  private final int[] cells = new int[MAX_NEAR];

  EventAssociation(
      SensorGeometry geometry, ActivityGrid grid, ClutterMap clutter, BirthDetector births) {
    this.grid = grid;
    this.clutter = clutter;
    this.births = births;
    columns = (geometry.width() >> BLOCK_SHIFT) + 1;
    rows = (geometry.height() >> BLOCK_SHIFT) + 1;
    head = new int[columns * rows];
  }

  void associate(List<Component> components) {
    index(components);
    for (int i = 0; i < grid.count(); i++) {
      associate(grid.tile(i));
    }
  }

  /** Lists for each block the components whose template may reach it. */
  private void index(List<Component> components) {
    Arrays.fill(head, -1);
    entries = 0;
    for (int i = 0; i < components.size(); i++) {
      Component component = components.get(i);
      component.beginTick();
      double reach = component.shape.reach();
      double reachX = reach + Math.abs(component.vx()) * ObjectTracker.TICK_S;
      double reachY = reach + Math.abs(component.vy()) * ObjectTracker.TICK_S;
      int firstColumn = Math.max(0, block(component.x() - reachX));
      int lastColumn = Math.min(columns - 1, block(component.x() + reachX));
      int firstRow = Math.max(0, block(component.y() - reachY));
      int lastRow = Math.min(rows - 1, block(component.y() + reachY));
      for (int row = firstRow; row <= lastRow; row++) {
        for (int column = firstColumn; column <= lastColumn; column++) {
          add(row * columns + column, component);
        }
      }
    }
  }

  private static int block(double px) {
    return (int) Math.floor(px) >> BLOCK_SHIFT;
  }

  private void add(int block, Component component) {
    if (entries == next.length) {
      next = Arrays.copyOf(next, 2 * entries);
      entry = Arrays.copyOf(entry, 2 * entries);
    }
    entry[entries] = component;
    next[entries] = head[block];
    head[block] = entries++;
  }

  private void associate(int tile) {
    int x = grid.x(tile);
    int y = grid.y(tile);
    double timeS = grid.meanS(tile);
    int count = 0;
    int block = (y >> BLOCK_SHIFT) * columns + (x >> BLOCK_SHIFT);
    for (int e = head[block]; e >= 0 && count < MAX_NEAR; e = next[e]) {
      Component component = entry[e];
      near[count] = component;
      nearX[count] = x - (component.x() + component.vx() * timeS);
      nearY[count++] = y - (component.y() + component.vy() * timeS);
    }
    clutter.touch(tile);
    int cell = clutter.cellAt(x, y);
    int unexplained = 0;
    for (int left = grid.pixels(tile); left != 0; left &= left - 1) {
      int pixel = Integer.numberOfTrailingZeros(left);
      double share = associate(tile, pixel, cell, count);
      clutter.add(tile, pixel, cell, share);
      unexplained |= share > 0.5 ? 1 << pixel : 0;
    }
    if (unexplained != 0) {
      births.remember(tile, unexplained);
    }
  }

  /** Shares one event; returns the share that is clutter. */
  private double associate(int tile, int pixel, int cell, int count) {
    double noise = clutter.rate(tile, pixel);
    double sum = noise;
    int dx = ActivityGrid.pixelX(pixel);
    int dy = ActivityGrid.pixelY(pixel);
    for (int k = 0; k < count; k++) {
      Component component = near[k];
      int at = component.shape.cell(nearX[k] + dx, nearY[k] + dy);
      cells[k] = at;
      intensity[k] = at < 0 ? 0 : component.intensity * component.shape.density[at];
      sum += component.active * intensity[k];
    }
    if (sum == noise) {
      return 1;
    }
    double repeat = clutter.repeatRate(tile, pixel, cell);
    for (int k = 0; k < count; k++) {
      if (intensity[k] == 0) {
        continue;
      }
      Component component = near[k];
      double mine = component.active * intensity[k];
      component.addLikelihood(intensity[k] / (sum - mine));
      double share = mine / sum;
      int at = cells[k];
      ShapeTemplate shape = component.shape;
      if (!component.object.isDecided()) {
        // no event decides alone
        double novelty = Math.log(intensity[k] / repeat);
        double most = ObjectRelations.DECISIVE_NAT;
        component.novelty += share * Math.max(-most, Math.min(most, novelty));
      }
      component.weight += share;
      component.gradientX -= share * shape.gradientX[at];
      component.gradientY -= share * shape.gradientY[at];
      shape.add(at, share);
    }
    return noise / sum;
  }
}
