package haltere.core.overlay;

/**
 * Draws marks in sensor coordinates: x to the right, y up, (0, 0) at the centre of the bottom left
 * pixel, one unit per pixel, angles in radians counterclockwise from x. All marks but texts are
 * lines from point to point where a canvas has nothing better.
 *
 * @since 0.1
 */
public interface OverlayCanvas {
  /** Corners of an ellipse that is drawn as lines. */
  int ELLIPSE_CORNERS = 32;

  /**
   * A circle's outline.
   *
   * @param x centre
   * @param y centre
   * @param radius in pixels of the sensor
   * @param style meaning
   */
  default void circle(double x, double y, double radius, MarkStyle style) {
    ellipse(x, y, radius, radius, 0, style);
  }

  /**
   * A straight line.
   *
   * @param x1 start
   * @param y1 start
   * @param x2 end
   * @param y2 end
   * @param style meaning
   */
  default void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    polyline(new double[] {x1, x2}, new double[] {y1, y2}, 2, style);
  }

  /**
   * Lines from point to point.
   *
   * @param x columns
   * @param y rows, as many
   * @param points how many points of the arrays to take
   * @param style meaning
   */
  void polyline(double[] x, double[] y, int points, MarkStyle style);

  /**
   * An ellipse's outline.
   *
   * @param x centre
   * @param y centre
   * @param radiusA half axis at {@code angleRad}
   * @param radiusB half axis orthogonal to it
   * @param angleRad direction of the first axis
   * @param style meaning
   */
  default void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    double cos = Math.cos(angleRad);
    double sin = Math.sin(angleRad);
    double[] pointsX = new double[ELLIPSE_CORNERS + 1];
    double[] pointsY = new double[ELLIPSE_CORNERS + 1];
    for (int i = 0; i <= ELLIPSE_CORNERS; i++) {
      double a = radiusA * Math.cos(2 * Math.PI * i / ELLIPSE_CORNERS);
      double b = radiusB * Math.sin(2 * Math.PI * i / ELLIPSE_CORNERS);
      pointsX[i] = x + a * cos - b * sin;
      pointsY[i] = y + a * sin + b * cos;
    }
    polyline(pointsX, pointsY, pointsX.length, style);
  }

  /**
   * A rectangle's outline.
   *
   * @param x left edge
   * @param y bottom edge
   * @param width to the right
   * @param height upwards
   * @param style meaning
   */
  default void rectangle(double x, double y, double width, double height, MarkStyle style) {
    polyline(
        new double[] {x, x + width, x + width, x, x},
        new double[] {y, y, y + height, y + height, y},
        5,
        style);
  }

  /**
   * A short text.
   *
   * @param x where it starts
   * @param y its base line
   * @param text one line
   * @param style meaning
   */
  void text(double x, double y, String text, MarkStyle style);
}
