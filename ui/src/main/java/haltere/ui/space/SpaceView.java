package haltere.ui.space;

import java.util.List;

/**
 * The viewpoint in space: around a centre, with azimuth and elevation, parallel projection, z up.
 * Points become pixels to the right and up.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class SpaceView {
  private static final double LIMIT_RAD = Math.toRadians(89);

  private SpaceBounds bounds = SpaceBounds.of(List.of());
  private double azimuthRad = Math.toRadians(35);
  private double elevationRad = Math.toRadians(25);
  private double pixelsPerM = 100;
  private double widthPx = 400;
  private double heightPx = 400;

  /** Fits points, in metres, into a picture of a size in pixels. */
  public void fit(Iterable<double[]> points, double newWidthPx, double newHeightPx) {
    widthPx = newWidthPx;
    heightPx = newHeightPx;
    bounds = SpaceBounds.of(points);
    pixelsPerM = 0.95 * Math.min(widthPx, heightPx) / bounds.diagonalM();
  }

  /** Turns to the left and upwards, as far as straight above. */
  public void turn(double byAzimuthRad, double byElevationRad) {
    azimuthRad += byAzimuthRad;
    elevationRad = Math.max(-LIMIT_RAD, Math.min(LIMIT_RAD, elevationRad + byElevationRad));
  }

  /** Zooms in by a factor above 1, or out. */
  public void zoom(double factor) {
    pixelsPerM *= Math.max(0.1, Math.min(10, factor));
  }

  /** Size of a metre, pixels. */
  public double pixelsPerM() {
    return pixelsPerM;
  }

  /** Projects a point in metres to pixels to the right and up. */
  public double[] project(double... point) {
    double x = point[0] - bounds.middle(0);
    double y = point[1] - bounds.middle(1);
    double z = point[2] - bounds.middle(2);
    double right = -Math.sin(azimuthRad) * x + Math.cos(azimuthRad) * y;
    double away = Math.cos(azimuthRad) * x + Math.sin(azimuthRad) * y;
    double up = Math.cos(elevationRad) * z - Math.sin(elevationRad) * away;
    return new double[] {widthPx / 2 + pixelsPerM * right, heightPx / 2 + pixelsPerM * up};
  }
}
