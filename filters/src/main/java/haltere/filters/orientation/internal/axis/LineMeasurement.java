package haltere.filters.orientation.internal.axis;

import haltere.filters.orientation.camera.CameraModel;

/**
 * The measured line of a camera: undistorted angle, variance and derivatives; after an update,
 * residual and result. Reused.
 */
public final class LineMeasurement {
  /** n₀ and n₁ of {@link CameraModel#lineNormals}. */
  public final double[] n = new double[6];

  /** Index of the camera. */
  public int camera;

  private double sin;
  private double cos = 1;

  /** Variance of the angle. */
  public double varianceRad2;

  /** Whether the last update used the line. */
  public boolean used;

  /** Angle to the expected line before the update. */
  public double residualRad;

  /** Normalised innovation squared at its update. */
  public double nis;

  /** Estimate of its variance; NaN if the innovation does not determine it. */
  public double ownRad2;

  /**
   * Sets the observed angle.
   *
   * @param angleRad radians modulo pi
   */
  public void setAngle(double angleRad) {
    used = false;
    residualRad = Double.NaN;
    sin = Math.sin(angleRad);
    cos = Math.cos(angleRad);
  }

  /** n₀ u and n₁ u: the direction in the picture of an axis u. */
  double vx(double[] u) {
    return n[0] * u[0] + n[1] * u[1] + n[2] * u[2];
  }

  double vy(double[] u) {
    return n[3] * u[0] + n[4] * u[1] + n[5] * u[2];
  }

  /** The difference between the observed line and that of a direction, in (−π/2, π/2). */
  double residual(double[] direction) {
    return residual(vx(direction), vy(direction));
  }

  double residual(double vx, double vy) {
    double along = cos * vx + sin * vy;
    double across = sin * vx - cos * vy;
    return along == 0 && across == 0 ? 0 : Math.atan(across / along);
  }

  /** ∂θ/∂u at a direction u: (vx n₁ − vy n₀) / (vx² + vy²); false where the line is a point. */
  boolean gradient(double[] direction, double[] gradient) {
    double vx = vx(direction);
    double vy = vy(direction);
    double squares = vx * vx + vy * vy;
    for (int i = 0; i < 3; i++) {
      gradient[i] = (vx * n[3 + i] - vy * n[i]) / squares;
    }
    return squares > 1e-12;
  }

  /** Normal of the plane of line and camera, which contains the axis. */
  void planeNormal(double[] normal) {
    for (int i = 0; i < 3; i++) {
      normal[i] = sin * n[i] - cos * n[3 + i];
    }
  }
}
