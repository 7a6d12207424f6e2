package haltere.filters.object;

import java.util.Arrays;
import java.util.List;

/**
 * Assigns the events of a tick to components and clutter. Events are a Poisson process of clutter
 * and components (Streit, Poisson Point Processes, 2010, §3.2): an event is of component k with the
 * probability λ<sub>k</sub> / Σ λ at its pixel and time, the expectation step of Dempster, Laird
 * and Rubin (1977).
 */
final class EventAssociation {
  /** Largest number of components in a block of 16 × 16 pixels; others are ignored there. */
  private static final int MAX_NEAR = 16;

  private final ActivityGrid grid;
  private final ClutterMap clutter;
  private final BirthDetector births;

  /** Number of components in each block, and their indexes. */
  private final int[] counts;

  private final int[] near;
  private List<Component> components = List.of();
  private final Component[] nearby = new Component[MAX_NEAR];
  private final double[] nearX = new double[MAX_NEAR];
  private final double[] nearY = new double[MAX_NEAR];
  private final double[] intensity = new double[MAX_NEAR];
  private final int[] cells = new int[MAX_NEAR];

  EventAssociation(ActivityGrid grid, ClutterMap clutter, BirthDetector births) {
    this.grid = grid;
    this.clutter = clutter;
    this.births = births;
    counts = new int[grid.columns * grid.rows];
    near = new int[MAX_NEAR * counts.length];
  }

  void associate(List<Component> all) {
    components = all;
    index();
    for (int tile = grid.nextTile(0); tile >= 0; tile = grid.nextTile(tile + 1)) {
      associate(tile);
    }
  }

  /** Lists the components whose template may reach each block. */
  private void index() {
    Arrays.fill(counts, 0);
    components.forEach(Component::beginTick);
    for (int i = 0; i < components.size(); i++) {
      Component component = components.get(i);
      double reach = component.shape.reach();
      double reachX = reach + Math.abs(component.vx()) * ObjectTracker.TICK_S;
      double reachY = reach + Math.abs(component.vy()) * ObjectTracker.TICK_S;
      int firstColumn = Math.max(0, block(component.x() - reachX));
      int lastColumn = Math.min(grid.columns - 1, block(component.x() + reachX));
      int firstRow = Math.max(0, block(component.y() - reachY));
      int lastRow = Math.min(grid.rows - 1, block(component.y() + reachY));
      for (int row = firstRow; row <= lastRow; row++) {
        for (int column = firstColumn; column <= lastColumn; column++) {
          int block = row * grid.columns + column;
          if (counts[block] < MAX_NEAR) {
            near[block * MAX_NEAR + counts[block]++] = i;
          }
        }
      }
    }
  }

  private static int block(double px) {
    return (int) Math.floor(px) >> ActivityGrid.BLOCK_SHIFT;
  }

  private void associate(int tile) {
    int x = grid.x(tile);
    int y = grid.y(tile);
    int cell = clutter.cellAt(x, y);
    int block = tile >> ActivityGrid.BLOCK_SHIFT;
    double timeS = counts[block] == 0 ? 0 : grid.meanS(tile);
    int count = 0;
    for (int i = block * MAX_NEAR; i < block * MAX_NEAR + counts[block]; i++) {
      Component component = components.get(near[i]);
      double dx = x - (component.x() + component.vx() * timeS);
      double dy = y - (component.y() + component.vy() * timeS);
      double reach = component.shape.reach() + ActivityGrid.TILE_PX;
      if (Math.abs(dx) < reach && Math.abs(dy) < reach) {
        nearby[count] = component;
        nearX[count] = dx;
        nearY[count++] = dy;
      }
    }
    int unexplained = 0;
    for (int left = grid.pixels(tile); left != 0; left &= left - 1) {
      int pixel = Integer.numberOfTrailingZeros(left);
      boolean isFlicker = clutter.isFlickering(tile, pixel);
      double share = isFlicker ? 0 : count == 0 ? 1 : associate(tile, pixel, cell, count);
      clutter.add(tile, pixel, cell, share);
      unexplained |= share > 0.5 ? 1 << pixel : 0;
    }
    births.remember(tile, cell, unexplained);
  }

  /** Assigns one event; returns the share of clutter. */
  private double associate(int tile, int pixel, int cell, int count) {
    int dx = ActivityGrid.pixelX(pixel);
    int dy = ActivityGrid.pixelY(pixel);
    double noise = clutter.rate(tile, pixel);
    double sum = noise;
    for (int k = 0; k < count; k++) {
      Component component = nearby[k];
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
      Component component = nearby[k];
      double own = component.active * intensity[k];
      component.addLikelihood(intensity[k] / (sum - own));
      double share = own / sum;
      int at = cells[k];
      ShapeTemplate shape = component.shape;
      if (!component.object.isDecided()) {
        // no event decides alone
        double ratio = Math.min(1 / ObjectRelations.ERROR, intensity[k] / repeat);
        component.novelty += share * Math.log(Math.max(ObjectRelations.ERROR, ratio));
      }
      component.weight += share;
      component.gradientX -= share * shape.gradientX[at];
      component.gradientY -= share * shape.gradientY[at];
      component.gradientTurn -= share * shape.gradientTurn[at];
      shape.add(at, share);
    }
    return noise / sum;
  }
}
