package haltere.filters.plane;

/**
 * A pixel and the position on a plane that it sees.
 *
 * @param xPx column
 * @param yPx row, upwards
 * @param x first coordinate on the plane, in a unit of the user's choice
 * @param y second coordinate on the plane, in the same unit
 */
public record PointPair(double xPx, double yPx, double x, double y) {
  /** Checks that the numbers are finite. */
  public PointPair {
    if (!Double.isFinite(xPx + yPx + x + y)) {
      throw new IllegalArgumentException(
          "a pair of points must be finite: " + xPx + ", " + yPx + " at " + x + ", " + y);
    }
  }
}
