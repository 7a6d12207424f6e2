package haltere.filters.trail;

/**
 * An ellipse about a centre.
 *
 * @param majorPx half axis at the angle, pixels; the longer one by default
 * @param minorPx half axis across it, pixels
 * @param angleRad direction of the first half axis, counterclockwise from +x, radians
 */
public record Ellipse(double majorPx, double minorPx, double angleRad) {
  /**
   * The ellipse zᵀ C⁻¹ z = 1 of a symmetric matrix C, such as a covariance: its half axes are the
   * square roots of the eigenvalues, and its box has the half sides √xx and √yy.
   *
   * @param xx first diagonal entry, at least 0
   * @param xy entry beside the diagonal
   * @param yy second diagonal entry, at least 0
   * @return with an angle from 0 to π; a negative eigenvalue counts as 0
   */
  public static Ellipse of(double xx, double xy, double yy) {
    double half = 0.5 * (xx - yy);
    double apart = Math.sqrt(half * half + xy * xy);
    double mean = 0.5 * (xx + yy);
    double angle = 0.5 * Math.atan2(xy, half);
    return new Ellipse(
        Math.sqrt(mean + apart),
        Math.sqrt(Math.max(0, mean - apart)),
        angle < 0 ? angle + Math.PI : angle);
  }

  /**
   * {@return the ellipse with half axes times a factor}
   *
   * @param factor more than 0
   */
  public Ellipse times(double factor) {
    return new Ellipse(factor * majorPx, factor * minorPx, angleRad);
  }
}
