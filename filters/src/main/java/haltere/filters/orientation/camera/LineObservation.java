package haltere.filters.orientation.camera;

/**
 * Observation of one body by one camera at one time. Unknown values are NaN.
 *
 * @param camera index of the camera, from 0
 * @param xPx column of its middle, distorted pixels of this camera
 * @param yPx row of its middle, pixels of this camera
 * @param angleRad atan2(Δy, Δx) of its line in the same coordinates, known modulo π
 * @param areaPx its area, square pixels
 * @param eccentricity ratio of the axes if at least 1, below 1 the eccentricity of the ellipse
 */
public record LineObservation(
    int camera, double xPx, double yPx, double angleRad, double areaPx, double eccentricity) {
  public LineObservation {
    if (camera < 0) {
      throw new IllegalArgumentException("a camera index must not be negative: " + camera);
    }
  }

  /** {@return column, row and angle, a new array} */
  public double[] line() {
    return new double[] {xPx, yPx, angleRad};
  }

  /** {@return whether its position is known: both numbers are finite} */
  public boolean hasPosition() {
    return Double.isFinite(xPx) && Double.isFinite(yPx);
  }

  /** {@return long axis over short axis, at least 1, infinite for a line, NaN if unknown} */
  public double axisRatio() {
    return eccentricity >= 1
        ? eccentricity
        : eccentricity >= 0 ? 1 / Math.sqrt(1 - eccentricity * eccentricity) : Double.NaN;
  }
}
