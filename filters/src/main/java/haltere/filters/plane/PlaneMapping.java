package haltere.filters.plane;

/**
 * A map from pixels to a plane in the scene and back. Pixel columns x count to the right and rows y
 * upwards from the centre of the bottom left pixel; the axes and units of the plane are those of
 * the mapping, metres by default.
 *
 * <p>Thread rule: implementations are immutable and may be used from any thread.
 */
public interface PlaneMapping {
  /** The picture itself: positions on the plane are pixels. */
  PlaneMapping PICTURE = new Homography();

  /**
   * {@return whether a pixel sees the plane: false for NaN as well; the other methods on pixels are
   * valid only where this is true}
   *
   * @param xPx column, may lie beside the sensor
   * @param yPx row, may lie beside the sensor
   */
  boolean seesPlane(double xPx, double yPx);

  /**
   * {@return whether a position on the plane lies in front of the camera: false for NaN as well;
   * {@link #pixelX} and {@link #pixelY} are valid only where this is true}
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   */
  boolean isSeen(double x, double y);

  /**
   * {@return first coordinate of the position on the plane that a pixel sees}
   *
   * @param xPx column
   * @param yPx row
   */
  double planeX(double xPx, double yPx);

  /**
   * {@return second coordinate of the position on the plane that a pixel sees}
   *
   * @param xPx column
   * @param yPx row
   */
  double planeY(double xPx, double yPx);

  /**
   * {@return column that sees a position, pixels}
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   */
  double pixelX(double x, double y);

  /**
   * {@return row that sees a position, pixels}
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   */
  double pixelY(double x, double y);

  /**
   * {@return the derivatives of {@link #planeX} and {@link #planeY} by the pixel}
   *
   * @param xPx column
   * @param yPx row
   */
  PlaneJacobian jacobian(double xPx, double yPx);
}
