package haltere.filters.object;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/**
 * Connected regions of the template of a component. Two that stay separate become two components.
 */
final class RegionFinder {
  /** Least share of the events of the extent for a region. */
  private static final double MIN_SHARE = 0.1;

  /** Number of further checks in which regions must stay separate to become components. */
  private static final int CHECKS = 2;

  /** Ticks between two checks: a sixth of the memory of a shape. */
  static final int CHECK_TICKS = 5;

  /** A connected region; pixels from the middle of the template. */
  static final class ShapeRegion {
    private double mass;
    private double x;
    private double y;
    private double halfX;
    private double halfY;
    private int label;

    /** Checks since the first one. */
    private int checks;

    private double distance(double atX, double atY) {
      return Math.hypot(
          Math.max(0, Math.abs(atX - x) - halfX), Math.max(0, Math.abs(atY - y) - halfY));
    }
  }

  /** Number of the region of each cell, 0 for none yet, -1 outside of the extent. */
  private final int[] label = new int[ShapeTemplate.CELLS];

  private final int[] stack = new int[ShapeTemplate.CELLS];
  private ShapeRegion spare = new ShapeRegion();
  private List<ShapeRegion> regions = List.of();

  void clear() {
    regions = List.of();
  }

  void shift(double dx, double dy) {
    for (ShapeRegion region : regions) {
      region.x -= dx;
      region.y -= dy;
    }
  }

  /** Checks a template; returns a region that has stayed separate from the largest, or null. */
  ShapeRegion findApart(ShapeTemplate shape) {
    List<ShapeRegion> found = find(shape);
    if (found.size() < 2) {
      regions = List.of();
      return null;
    }
    for (ShapeRegion now : found) {
      ShapeRegion before = nearest(now);
      if (before != null) {
        now.checks = before.checks + 1;
      }
    }
    regions = found;
    ShapeRegion largest = Collections.max(found, Comparator.comparingDouble(region -> region.mass));
    for (ShapeRegion region : found) {
      if (region != largest && region.checks >= CHECKS && largest.checks >= CHECKS) {
        return region;
      }
    }
    return null;
  }

  /** The earlier region that this one continues, by position; each at most once. */
  private ShapeRegion nearest(ShapeRegion now) {
    ShapeRegion best = null;
    double min = 2 * Math.max(now.halfX, now.halfY);
    for (ShapeRegion region : regions) {
      double d = Math.hypot(region.x - now.x, region.y - now.y);
      if (region.label != 0 && d < min) {
        min = d;
        best = region;
      }
    }
    if (best != null) {
      best.label = 0;
    }
    return best;
  }

  /** Connected regions with at least a share of the events. */
  private List<ShapeRegion> find(ShapeTemplate shape) {
    for (int cell = 0; cell < ShapeTemplate.CELLS; cell++) {
      label[cell] = shape.isCore(cell) ? 0 : -1;
    }
    List<ShapeRegion> found = new ArrayList<>(2);
    int labels = 0;
    for (int cell = 0; cell < ShapeTemplate.CELLS; cell++) {
      if (label[cell] == 0) {
        fill(shape, cell, ++labels, spare);
        if (spare.mass > MIN_SHARE * shape.solidTotal) {
          found.add(spare);
          spare = new ShapeRegion();
        }
      }
    }
    return found;
  }

  private void fill(ShapeTemplate shape, int start, int number, ShapeRegion region) {
    int side = ShapeTemplate.SIDE;
    region.label = number;
    region.mass = 0;
    region.x = 0;
    region.y = 0;
    int top = 0;
    stack[top++] = start;
    label[start] = number;
    int lowX = side;
    int highX = -1;
    int lowY = side;
    int highY = -1;
    while (top > 0) {
      int here = stack[--top];
      int column = here % side;
      int row = here / side;
      double mass = shape.mass[here];
      region.mass += mass;
      region.x += mass * ShapeTemplate.X[here];
      region.y += mass * ShapeTemplate.Y[here];
      lowX = Math.min(lowX, column);
      highX = Math.max(highX, column);
      lowY = Math.min(lowY, row);
      highY = Math.max(highY, row);
      for (int r = Math.max(0, row - 1); r <= Math.min(side - 1, row + 1); r++) {
        for (int c = Math.max(0, column - 1); c <= Math.min(side - 1, column + 1); c++) {
          int next = r * side + c;
          if (label[next] == 0) {
            label[next] = number;
            stack[top++] = next;
          }
        }
      }
    }
    double cell = shape.cellPx;
    double scale = region.mass > 0 ? cell / region.mass : 0;
    region.x *= scale;
    region.y *= scale;
    region.halfX = 0.5 * (highX - lowX + 1) * cell;
    region.halfY = 0.5 * (highY - lowY + 1) * cell;
  }

  /** Moves the cells nearest to a region from one template to another. */
  void move(ShapeRegion leaving, ShapeTemplate from, ShapeTemplate to) {
    for (int cell = 0; cell < ShapeTemplate.CELLS; cell++) {
      if (from.mass[cell] > 0 && owner(cell, from) == leaving) {
        to.add(cell, from.mass[cell]);
        from.add(cell, -from.mass[cell]);
      }
    }
    regions = List.of();
  }

  private ShapeRegion owner(int cell, ShapeTemplate shape) {
    ShapeRegion best = null;
    double min = Double.POSITIVE_INFINITY;
    for (ShapeRegion region : regions) {
      double d =
          label[cell] == region.label
              ? -1
              : region.distance(
                  ShapeTemplate.X[cell] * shape.cellPx, ShapeTemplate.Y[cell] * shape.cellPx);
      if (d < min) {
        min = d;
        best = region;
      }
    }
    return best;
  }
}
