package haltere.filters.plane;

/**
 * A map from pixels to a plane in the scene and back. Pixel columns x count to the right and rows y
 * upwards from the centre of the bottom left pixel; the axes and units of the plane are those of
 * the mapping, metres unless it says otherwise.
 *
 * <p>Thread rule: implementations are immutable and may be used from any thread.
 */
public interface PlaneMapping {
  /** The picture itself: positions on the plane are pixels. */
  PlaneMapping PICTURE = new Homography();

  /**
   * Whether a pixel sees the plane.
   *
   * @param xPx column, may lie beside the sensor
   * @param yPx row, may lie beside the sensor
   * @return false for NaN as well; the other methods on pixels are valid only where this is true
   */
  boolean seesPlane(double xPx, double yPx);

  /**
   * Whether a position on the plane lies in front of the camera.
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   * @return false for NaN as well; {@link #pixelX} and {@link #pixelY} are valid only where this is
   *     true
   */
  boolean isSeen(double x, double y);

  /**
   * First coordinate of what a pixel sees.
   *
   * @param xPx column
   * @param yPx row
   * @return position on the plane
   */
  double planeX(double xPx, double yPx);

  /**
   * Second coordinate of what a pixel sees.
   *
   * @param xPx column
   * @param yPx row
   * @return position on the plane
   */
  double planeY(double xPx, double yPx);

  /**
   * Column that sees a position.
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   * @return pixels
   */
  double pixelX(double x, double y);

  /**
   * Row that sees a position.
   *
   * @param x first coordinate on the plane
   * @param y second coordinate on the plane
   * @return pixels
   */
  double pixelY(double x, double y);

  /**
   * Derivatives of the position on the plane by the pixel.
   *
   * @param xPx column
   * @param yPx row
   * @return the Jacobian of {@link #planeX} and {@link #planeY}
   */
  PlaneJacobian jacobian(double xPx, double yPx);
}
