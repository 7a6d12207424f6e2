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

  // With the radius taken out: information on the middle, and that times how far it moves.
  double middleXx;
  double middleXy;
  double middleYy;
  double middleX;
  double middleY;

  private double pulled;
  private double share;

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

  /**
   * Takes the radius out of the equations, as far as the events tell it.
   *
   * @param known what is known of it before, in units of an event
   * @param expectedMove by how much it is expected to be larger than the one that they are about
   */
  void takeOutRadius(double known, double expectedMove) {
    share = 1 / (count + known);
    pulled = r + known * expectedMove;
    middleXx = xx - xr * xr * share;
    middleXy = xy - xr * yr * share;
    middleYy = yy - yr * yr * share;
    middleX = x - xr * pulled * share;
    middleY = y - yr * pulled * share;
  }

  /** By how much the radius is larger if the middle moves so far. */
  double radiusMove(double moveX, double moveY) {
    return (pulled - xr * moveX - yr * moveY) * share;
  }

  /** How much of the radius is known from the events, and not from before: 0 to 1. */
  double shareOfRadius() {
    return count * share;
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
