package haltere.testing.objects;

/**
 * A rectangle in the picture, y upwards.
 *
 * @param x0 left side, pixels
 * @param y0 lower side, pixels
 * @param x1 right side, pixels, at least {@code x0}
 * @param y1 upper side, pixels, at least {@code y0}
 */
public record Box(double x0, double y0, double x1, double y1) {
  /** Checks the sides. */
  public Box {
    if (!(x0 <= x1 && y0 <= y1)) {
      throw new IllegalArgumentException(
          "a box has its sides in order: " + x0 + ", " + y0 + ", " + x1 + ", " + y1);
    }
  }

  /**
   * A box around a centre.
   *
   * @param x column of the centre, pixels
   * @param y row of the centre, pixels
   * @param halfWidth at least 0, pixels
   * @param halfHeight at least 0, pixels
   * @return the box
   */
  public static Box around(double x, double y, double halfWidth, double halfHeight) {
    return new Box(x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight);
  }

  /**
   * Column of the centre.
   *
   * @return pixels
   */
  public double centreX() {
    return (x0 + x1) / 2;
  }

  /**
   * Row of the centre.
   *
   * @return pixels
   */
  public double centreY() {
    return (y0 + y1) / 2;
  }

  /**
   * Extent in x.
   *
   * @return pixels, at least 0
   */
  public double width() {
    return x1 - x0;
  }

  /**
   * Extent in y.
   *
   * @return pixels, at least 0
   */
  public double height() {
    return y1 - y0;
  }

  /**
   * Whether a point is inside or near.
   *
   * @param x column, pixels
   * @param y row, pixels
   * @param marginPx how far outside a point may be in x and in y
   * @return true on the border too
   */
  public boolean contains(double x, double y, double marginPx) {
    return x >= x0 - marginPx && x <= x1 + marginPx && y >= y0 - marginPx && y <= y1 + marginPx;
  }

  /**
   * A box moved and scaled about the origin.
   *
   * @param scaleX factor of x first, negative mirrors
   * @param scaleY factor of y first, negative mirrors
   * @param dx added to x, pixels
   * @param dy added to y, pixels
   * @return a new box
   */
  public Box mapped(double scaleX, double scaleY, double dx, double dy) {
    double a = x0 * scaleX + dx;
    double b = x1 * scaleX + dx;
    double c = y0 * scaleY + dy;
    double d = y1 * scaleY + dy;
    return new Box(Math.min(a, b), Math.min(c, d), Math.max(a, b), Math.max(c, d));
  }

  /**
   * Gap to another box.
   *
   * @param other another box
   * @return the larger of the gaps in x and y, pixels; negative where the boxes overlap
   */
  public double gapTo(Box other) {
    return Math.max(Math.max(other.x0 - x1, x0 - other.x1), Math.max(other.y0 - y1, y0 - other.y1));
  }

  /**
   * The smallest box around this and another.
   *
   * @param other another box
   * @return a box that holds both
   */
  public Box with(Box other) {
    return new Box(
        Math.min(x0, other.x0),
        Math.min(y0, other.y0),
        Math.max(x1, other.x1),
        Math.max(y1, other.y1));
  }

  /**
   * Share of this box that is in another.
   *
   * @param other another box
   * @return 0 to 1; NaN if this has no area
   */
  public double shareIn(Box other) {
    double across = Math.min(x1, other.x1) - Math.max(x0, other.x0);
    double upwards = Math.min(y1, other.y1) - Math.max(y0, other.y0);
    return Math.max(0, across) * Math.max(0, upwards) / (width() * height());
  }
}
