package haltere.filters.cluster;

/**
 * The normal equations of a circle through events, for its middle and radius: sums over events of
 * (n, 1)(n, 1)ᵀ, (n, 1) m and m², with n the direction from where the middle is expected to an
 * event and m how far outside the expected circle it is. Thread rule: that of its owner.
 */
final class OutlineSums {
  double count;
  double xx;
  double xy;
  double xr;
  double yy;
  double yr;
  double x;
  double y;
  double r;
  double squares;

  void clear() {
    count = 0;
    xx = 0;
    xy = 0;
    xr = 0;
    yy = 0;
    yr = 0;
    x = 0;
    y = 0;
    r = 0;
    squares = 0;
  }

  void add(double nx, double ny, double m, double weight) {
    double wx = weight * nx;
    double wy = weight * ny;
    count += weight;
    xx += wx * nx;
    xy += wx * ny;
    xr += wx;
    yy += wy * ny;
    yr += wy;
    x += wx * m;
    y += wy * m;
    r += weight * m;
    squares += weight * m * m;
  }

  /** What is left of m² with the middle and the radius moved. */
  double rest(double moveX, double moveY, double moveR) {
    return squares
        - 2 * (x * moveX + y * moveY + r * moveR)
        + moveX * (xx * moveX + 2 * xy * moveY + 2 * xr * moveR)
        + moveY * (yy * moveY + 2 * yr * moveR)
        + count * moveR * moveR;
  }
}
