package haltere.filters.orientation.camera;

/**
 * What one camera saw of one body at one time. What is not known is NaN.
 *
 * @param camera index of the camera, from 0
 * @param xPx column of its middle, pixels of this camera, as seen through the lens
 * @param yPx row of its middle, pixels of this camera
 * @param angleRad atan2(Δy, Δx) of its line in the same coordinates, known modulo π
 * @param areaPx how large it was, square pixels
 * @param eccentricity how long against its width: from 1 on the ratio of the axes, below 1 the
 *     eccentricity of the ellipse
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
