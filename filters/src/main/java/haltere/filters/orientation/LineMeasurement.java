package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;

/**
 * A camera's line as a filter of the axis takes it: how the angle comes from a direction, the angle
 * without the lens, its variance; and, afterwards, what became of it. Reused.
 */
final class LineMeasurement {
  /** n₀ and n₁ of {@link CameraModel#lineNormals}. */
  final double[] n = new double[6];

  int camera;
  private double sin;
  private double cos = 1;
  double varianceRad2;

  /** By how much more than the camera's usual variance, because the detection is round. */
  double roundness;

  boolean used;

  /** Angle from the expected line, before any update. */
  double residualRad;

  /** Normalised innovation squared when it was taken in. */
  double nis;

  /** What it says of its own variance, on average; NaN where it says nothing. */
  double ownRad2;

  /** What was observed, radians, modulo pi. */
  void setAngle(double angleRad) {
    sin = Math.sin(angleRad);
    cos = Math.cos(angleRad);
  }

  /** The difference between the observed line and that of a direction, in (−π/2, π/2). */
  double residual(double[] direction) {
    double vx = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
    double vy = n[3] * direction[0] + n[4] * direction[1] + n[5] * direction[2];
    return residual(vx, vy);
  }

  double residual(double vx, double vy) {
    double along = cos * vx + sin * vy;
    double across = sin * vx - cos * vy;
    return along == 0 && across == 0 ? 0 : Math.atan(across / along);
  }

  /** ∂θ/∂u at a direction u: (vx n₁ − vy n₀) / (vx² + vy²); false where the line is a point. */
  boolean gradient(double[] direction, double[] gradient) {
    double vx = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
    double vy = n[3] * direction[0] + n[4] * direction[1] + n[5] * direction[2];
    double squares = vx * vx + vy * vy;
    for (int i = 0; i < 3; i++) {
      gradient[i] = (vx * n[3 + i] - vy * n[i]) / squares;
    }
    return squares > 1e-12;
  }

  /** Normal of the plane that the line and the camera span: the body's axis lies in it. */
  void planeNormal(double[] normal) {
    for (int i = 0; i < 3; i++) {
      normal[i] = sin * n[i] - cos * n[3 + i];
    }
  }
}
