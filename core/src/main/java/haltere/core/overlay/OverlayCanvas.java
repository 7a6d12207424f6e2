package haltere.core.overlay;

/**
 * Takes marks in sensor coordinates: x to the right, y up, (0, 0) at the centre of the bottom left
 * pixel, one unit per pixel, angles in radians counterclockwise from x.
 */
public interface OverlayCanvas {
  /**
   * A circle's outline.
   *
   * @param x centre
   * @param y centre
   * @param radius in pixels of the sensor
   * @param style meaning
   */
  void circle(double x, double y, double radius, MarkStyle style);

  /**
   * A straight line.
   *
   * @param x1 start
   * @param y1 start
   * @param x2 end
   * @param y2 end
   * @param style meaning
   */
  void line(double x1, double y1, double x2, double y2, MarkStyle style);

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
  void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style);

  /**
   * A rectangle's outline.
   *
   * @param x left edge
   * @param y bottom edge
   * @param width to the right
   * @param height upwards
   * @param style meaning
   */
  void rectangle(double x, double y, double width, double height, MarkStyle style);

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
