package haltere.testing.evaluation;

/**
 * Where an object is at one time, true or estimated.
 *
 * @param timeUs time, microseconds
 * @param id identity, the same as long as it is the same object or track
 * @param x position, finite
 * @param y position, finite
 * @param vx velocity a second, NaN if unknown
 * @param vy velocity a second, NaN if unknown
 */
public record ObjectPoint(long timeUs, int id, double x, double y, double vx, double vy) {
  /** Checks the position. */
  public ObjectPoint {
    if (!Double.isFinite(x) || !Double.isFinite(y)) {
      throw new IllegalArgumentException(
          "object " + id + " at " + timeUs + " us is nowhere: " + x + ", " + y);
    }
  }

  /**
   * A point of unknown velocity.
   *
   * @param timeUs time, microseconds
   * @param id identity
   * @param x position
   * @param y position
   */
  public ObjectPoint(long timeUs, int id, double x, double y) {
    this(timeUs, id, x, y, Double.NaN, Double.NaN);
  }

  /**
   * Euclidean distance of the positions.
   *
   * @param other another point
   * @return at least 0
   */
  public double distanceTo(ObjectPoint other) {
    return Math.hypot(x - other.x, y - other.y);
  }

  /**
   * Size of the velocity.
   *
   * @return NaN if it is unknown
   */
  public double speed() {
    return Math.hypot(vx, vy);
  }
}
