package haltere.filters.track;

import haltere.core.event.SensorGeometry;
import java.util.Objects;

/**
 * Maps pixels to metres on a flat road and back, for a camera on a bridge of height h that looks
 * along the road.
 *
 * <p>J. Cardinale, "Tracking objects and wing beat analysis methods of a fruit fly with the
 * event-based silicon retina", part I. Rows y count from the bottom one (0) to that of the
 * vanishing point (y_v), columns x from the left. The angle below the horizon is β = atan(h / d₁)
 * at the bottom row and γ_v = atan(h / d_v) at y_v, in between it is linear in the row, so that a
 * pixel subtends δ = (β − γ_v) / y_v:
 *
 * <pre>
 *   γ(y)    = β − δ y
 *   d(y)    = h / tan γ(y)                   distance along the road
 *   X(x, y) = (x − x_v) δ √(h² + d(y)²)      position across it, to the right
 * </pre>
 *
 * <p>The same angle δ per pixel holds across as along, so pixels are taken as square whatever the
 * sides of the sensor are. The original took a quarter of this width, and its way back was not the
 * inverse on a sensor that is not square.
 *
 * <p>Rows at or above that of the vanishing point are off the road: the formula still has a value
 * at y_v, which is d_v, but means nothing beyond it.
 *
 * <p>Thread rule: immutable, may be used from any thread.
 */
public final class RoadMapping {
  private final RoadSettings settings;
  private final double heightM;
  private final double vanishingX;
  private final double vanishingY;
  private final double bottomAngle;
  private final double pixelAngle;

  /**
   * The mapping of a camera.
   *
   * @param settings where it stands and looks
   * @param sensor its pixels, at least two rows unless the vanishing point is marked
   */
  public RoadMapping(RoadSettings settings, SensorGeometry sensor) {
    this.settings = Objects.requireNonNull(settings, "settings");
    VanishingPoint vanishing = settings.vanishingPoint().on(sensor);
    heightM = settings.bridgeHeightM();
    vanishingX = vanishing.xPx();
    vanishingY = vanishing.yPx();
    bottomAngle = Math.atan2(heightM, settings.nearestM());
    pixelAngle = (bottomAngle - Math.atan2(heightM, settings.farthestM())) / vanishingY;
  }

  /**
   * What the mapping was made of.
   *
   * @return the settings
   */
  public RoadSettings settings() {
    return settings;
  }

  /**
   * Column of the vanishing point in use.
   *
   * @return pixels
   */
  public double vanishingX() {
    return vanishingX;
  }

  /**
   * Row of the vanishing point in use.
   *
   * @return pixels above the bottom row
   */
  public double vanishingY() {
    return vanishingY;
  }

  /**
   * The angle that a pixel subtends.
   *
   * @return δ, radians
   */
  public double pixelAngle() {
    return pixelAngle;
  }

  /**
   * Whether a row sees road. A row some way below the sensor does, as far as it still looks ahead.
   *
   * @param yPx row above the bottom row; NaN sees nothing
   * @return true below the row of the vanishing point
   */
  public boolean onRoad(double yPx) {
    return yPx < vanishingY && angle(yPx) < Math.PI / 2;
  }

  /**
   * Distance along the road.
   *
   * @param yPx row above the bottom row, where {@link #onRoad} holds
   * @return metres from below the camera
   */
  public double distanceM(double yPx) {
    return heightM / Math.tan(angle(yPx));
  }

  /**
   * Position across the road.
   *
   * @param xPx column
   * @param yPx row above the bottom row, where {@link #onRoad} holds
   * @return metres to the right of the vertical plane through the camera and the vanishing point
   */
  public double lateralM(double xPx, double yPx) {
    return (xPx - vanishingX) * lateralPerX(yPx);
  }

  /**
   * The row that sees a distance.
   *
   * @param distanceM metres along the road, more than 0
   * @return pixels above the bottom row
   */
  public double rowOf(double distanceM) {
    return (bottomAngle - Math.atan2(heightM, distanceM)) / pixelAngle;
  }

  /**
   * The column that sees a place on the road.
   *
   * @param lateralM metres to the right
   * @param distanceM metres along the road
   * @return pixels
   */
  public double columnOf(double lateralM, double distanceM) {
    return vanishingX + lateralM / (pixelAngle * Math.hypot(heightM, distanceM));
  }

  /**
   * Entry ∂X/∂x of the Jacobian. The distance does not depend on the column, so ∂d/∂x is 0.
   *
   * @param yPx row above the bottom row
   * @return δ √(h² + d²), metres a pixel
   */
  public double lateralPerX(double yPx) {
    return pixelAngle * Math.hypot(heightM, distanceM(yPx));
  }

  /**
   * Entry ∂X/∂y of the Jacobian.
   *
   * @param xPx column
   * @param yPx row above the bottom row
   * @return (x − x_v) δ² d √(h² + d²) / h, metres a pixel
   */
  public double lateralPerY(double xPx, double yPx) {
    return lateralM(xPx, yPx) * pixelAngle * distanceM(yPx) / heightM;
  }

  /**
   * Entry ∂d/∂y of the Jacobian.
   *
   * @param yPx row above the bottom row
   * @return δ (h² + d²) / h, metres a pixel
   */
  public double distancePerY(double yPx) {
    double range = Math.hypot(heightM, distanceM(yPx));
    return pixelAngle * range * range / heightM;
  }

  /**
   * What an uncertainty in pixels is worth in metres, J C Jᵀ. To first order: where a standard
   * deviation of the row comes near the rest of the way to the vanishing point, the road is more
   * uncertain than this, and lopsided.
   *
   * @param xPx column
   * @param yPx row above the bottom row, where {@link #onRoad} holds
   * @param xxPx2 variance of the column, px²
   * @param xyPx2 covariance of column and row, px²
   * @param yyPx2 variance of the row, px²
   * @return covariance on the road
   */
  public GroundCovariance covariance(
      double xPx, double yPx, double xxPx2, double xyPx2, double yyPx2) {
    double a = lateralPerX(yPx);
    double b = lateralPerY(xPx, yPx);
    double c = distancePerY(yPx);
    return new GroundCovariance(
        a * a * xxPx2 + 2 * a * b * xyPx2 + b * b * yyPx2,
        c * (a * xyPx2 + b * yyPx2),
        c * c * yyPx2);
  }

  private double angle(double yPx) {
    return bottomAngle - pixelAngle * yPx;
  }
}
