package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The perspective of a camera on a bridge: the angle below the horizon is linear in the row, and a
 * pixel subtends the same angle across as along. The line of sight of a pixel is straight: at a
 * slant range r the point (u r, r cos g, h - r sin g), where g is the row's angle and u the
 * column's tangent; so its intersections with boxes are exact.
 *
 * <p>Coordinates in metres: x to the right, d ahead along the road, z up, 0 under the camera.
 *
 * <p>Thread rule: immutable.
 */
final class RoadCamera {
  final double heightM;
  final double vanishingXPx;
  final double vanishingYPx;
  final double bottomAngle;
  final double radPerPx;

  RoadCamera(RoadCameraSettings settings, SensorSettings sensor) {
    heightM = settings.bridgeHeightM();
    vanishingXPx = (sensor.widthPx() - 1) * settings.vanishingX();
    vanishingYPx = (sensor.heightPx() - 1) * settings.vanishingY();
    bottomAngle = StrictMath.atan(heightM / settings.bottomRowM());
    double vanishingAngle = StrictMath.atan(heightM / settings.vanishingRowM());
    radPerPx = (bottomAngle - vanishingAngle) / vanishingYPx;
  }

  /** Angle of a row below the horizon. */
  double angle(double row) {
    return bottomAngle - radPerPx * row;
  }

  /** Tangent of a column: metres to the right per metre of slant range. */
  double tangent(double column) {
    return (column - vanishingXPx) * radPerPx;
  }

  /** The row that sees a point; points behind the camera have rows below the sensor. */
  double row(double d, double z) {
    return (bottomAngle - StrictMath.atan2(heightM - z, d)) / radPerPx;
  }

  /** The column that sees a point. */
  double column(double x, double d, double z) {
    double drop = heightM - z;
    return vanishingXPx + x / (radPerPx * Math.sqrt(d * d + drop * drop));
  }

  /** Distance along the road of the ground point that a row sees, NaN at and above the horizon. */
  double groundDistance(double row) {
    double angle = angle(row);
    return angle > 0 ? heightM / StrictMath.tan(angle) : Double.NaN;
  }

  /** Lateral position of the ground point that a pixel sees. */
  double groundX(double column, double row) {
    double d = groundDistance(row);
    return tangent(column) * Math.sqrt(heightM * heightM + d * d);
  }
}
