package haltere.filters.plane;

import haltere.core.event.SensorGeometry;

/**
 * Maps pixels to metres on a flat road and back, for a camera on a bridge of height h that looks
 * along the road: J. Cardinale (2006), "Tracking objects and wing beat analysis methods of a fruit
 * fly with the event-based silicon retina", part I.
 *
 * <p>Rows y count from the bottom one (0) to that of the vanishing point (y_v). The angle below the
 * horizon is β = atan(h / d₁) at the bottom row and γ_v = atan(h / d_v) at y_v, and linear in the
 * row between them, so that a pixel subtends δ = (β − γ_v) / y_v:
 *
 * <pre>
 *   γ(y)    = β − δ y
 *   d(y)    = h / tan γ(y)                   second coordinate: distance along the road, metres
 *   X(x, y) = (x − x_v) δ √(h² + d(y)²)      first coordinate: to the right, metres
 * </pre>
 *
 * <p>Pixels are square: δ holds across the road as along it. Rows at or above y_v see no road.
 */
public final class RoadMapping implements PlaneMapping {
  private final double heightM;
  private final double vanishingX;
  private final double vanishingY;
  private final double bottomAngle;
  private final double pixelAngle;

  /**
   * The mapping of a camera.
   *
   * @param settings its position and view
   * @param sensor its pixels, at least two rows unless the vanishing point is marked
   */
  public RoadMapping(RoadViewSettings settings, SensorGeometry sensor) {
    VanishingPoint vanishing = settings.vanishingPoint().on(sensor);
    heightM = settings.bridgeHeightM();
    vanishingX = vanishing.xPx();
    vanishingY = vanishing.yPx();
    bottomAngle = Math.atan2(heightM, settings.nearestM());
    pixelAngle = (bottomAngle - Math.atan2(heightM, settings.farthestM())) / vanishingY;
  }

  /** {@return height of the camera, metres above the road} */
  public double heightM() {
    return heightM;
  }

  @Override
  public boolean seesPlane(double xPx, double yPx) {
    // a row below the sensor sees the road if it looks ahead
    return yPx < vanishingY && angle(yPx) < Math.PI / 2 && !Double.isNaN(xPx);
  }

  @Override
  public boolean isSeen(double x, double y) {
    return y > 0 && seesPlane(x, pixelY(x, y));
  }

  @Override
  public double planeX(double xPx, double yPx) {
    return (xPx - vanishingX) * metresPerColumn(planeY(xPx, yPx));
  }

  @Override
  public double planeY(double xPx, double yPx) {
    return heightM / Math.tan(angle(yPx));
  }

  @Override
  public double pixelX(double x, double y) {
    return vanishingX + x / metresPerColumn(y);
  }

  @Override
  public double pixelY(double x, double y) {
    return (bottomAngle - Math.atan2(heightM, y)) / pixelAngle;
  }

  /**
   * {@inheritDoc}
   *
   * <pre>
   *   ∂X/∂x = δ √(h² + d²)      ∂X/∂y = (x − x_v) δ² d √(h² + d²) / h
   *   ∂d/∂x = 0                 ∂d/∂y = δ (h² + d²) / h
   * </pre>
   */
  @Override
  public PlaneJacobian jacobian(double xPx, double yPx) {
    double distance = planeY(xPx, yPx);
    double column = metresPerColumn(distance);
    double aside = (xPx - vanishingX) * column * pixelAngle * distance / heightM;
    return new PlaneJacobian(column, aside, 0, column * column / (pixelAngle * heightM));
  }

  /** δ √(h² + d²). */
  private double metresPerColumn(double distanceM) {
    return pixelAngle * Math.sqrt(heightM * heightM + distanceM * distanceM);
  }

  private double angle(double yPx) {
    return bottomAngle - pixelAngle * yPx;
  }
}
