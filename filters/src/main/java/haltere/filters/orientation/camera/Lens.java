package haltere.filters.orientation.camera;

/**
 * Lens distortion: radial and tangential (Brown 1966; the same five numbers, in the same order, as
 * in most calibration programs).
 *
 * <p>In normalised coordinates, x = (x_px − c_x − s y) / f_x, y = (y_px − c_y) / f_y, r² = x² + y²:
 *
 * <pre>
 * x_d = x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)
 * y_d = y (1 + k1 r² + k2 r⁴ + k3 r⁶) + p1 (r² + 2 y²) + 2 p2 x y
 * </pre>
 *
 * @param fx focal length along x, pixels, above 0
 * @param fy focal length along y, pixels, above 0
 * @param skew s, pixels
 * @param cx principal point, pixels
 * @param cy principal point, pixels
 * @param k1 radial, second order
 * @param k2 radial, fourth order
 * @param p1 tangential
 * @param p2 tangential
 * @param k3 radial, sixth order
 */
record Lens(
    double fx,
    double fy,
    double skew,
    double cx,
    double cy,
    double k1,
    double k2,
    double p1,
    double p2,
    double k3) {
  private static final int MAX_STEPS = 30;

  Lens {
    if (!(fx > 0 && fy > 0)
        || !Double.isFinite(fx + fy + skew + cx + cy + k1 + k2 + p1 + p2 + k3)) {
      throw new IllegalArgumentException("a lens needs positive focal lengths and finite numbers");
    }
  }

  boolean isStraight() {
    return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0;
  }

  /** Distorts a point, column and row. */
  void distort(double[] point) {
    if (isStraight()) {
      return;
    }
    double y = (point[1] - cy) / fy;
    double x = (point[0] - cx - skew * y) / fx;
    double r2 = x * x + y * y;
    double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    double seenX = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
    double seenY = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
    point[0] = fx * seenX + skew * seenY + cx;
    point[1] = fy * seenY + cy;
  }

  /**
   * Undistorts a line (column, row, angle or NaN); false without a change outside the image of the
   * lens.
   */
  boolean undistort(double[] line) {
    if (isStraight()) {
      return true;
    }
    double seenY = (line[1] - cy) / fy;
    double seenX = (line[0] - cx - skew * seenY) / fx;
    double x = seenX;
    double y = seenY;
    for (int step = 0; step < MAX_STEPS; step++) {
      double r2 = x * x + y * y;
      double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
      double slope = k1 + r2 * (2 * k2 + 3 * r2 * k3);
      double missX = seenX - (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x));
      double missY = seenY - (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y);
      double jxx = radial + 2 * x * x * slope + 2 * p1 * y + 6 * p2 * x;
      double jxy = 2 * x * y * slope + 2 * p1 * x + 2 * p2 * y;
      double jyy = radial + 2 * y * y * slope + 6 * p1 * y + 2 * p2 * x;
      double determinant = jxx * jyy - jxy * jxy;
      if (!(determinant > 1e-6 && jxx > 0)) {
        return false; // beyond the fold of the distortion
      }
      if (missX * missX + missY * missY < 1e-28) {
        double alongY = Math.sin(line[2]) / fy;
        double alongX = (Math.cos(line[2]) - skew * alongY) / fx;
        double idealX = (jyy * alongX - jxy * alongY) / determinant;
        double idealY = (jxx * alongY - jxy * alongX) / determinant;
        line[0] = fx * x + skew * y + cx;
        line[1] = fy * y + cy;
        line[2] = Math.atan2(fy * idealY, fx * idealX + skew * idealY);
        return true;
      }
      x += (jyy * missX - jxy * missY) / determinant;
      y += (jxx * missY - jxy * missX) / determinant;
    }
    return false;
  }
}
