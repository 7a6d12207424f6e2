package haltere.filters.plane;

/**
 * A 2 x 2 Jacobian J of a map from (u, v) to (x, y). It maps small differences, velocities and, to
 * first order, covariances: J C Jᵀ.
 *
 * @param xu derivative of x by u
 * @param xv derivative of x by v
 * @param yu derivative of y by u
 * @param yv derivative of y by v
 */
public record PlaneJacobian(double xu, double xv, double yu, double yv) {
  /** {@return the Jacobian of the inverse map, J⁻¹, not finite where J is singular} */
  public PlaneJacobian inverse() {
    double scale = 1 / (xu * yv - xv * yu);
    return new PlaneJacobian(scale * yv, -scale * xv, -scale * yu, scale * xu);
  }

  /**
   * {@return the first entry of J (u, v)ᵀ, in the unit of x}
   *
   * @param u first entry of the vector
   * @param v second entry of the vector
   */
  public double x(double u, double v) {
    return xu * u + xv * v;
  }

  /**
   * {@return the second entry of J (u, v)ᵀ, in the unit of y}
   *
   * @param u first entry of the vector
   * @param v second entry of the vector
   */
  public double y(double u, double v) {
    return yu * u + yv * v;
  }

  /**
   * {@return the variance of x, an entry of J C Jᵀ, where (u, v) has the covariance C}
   *
   * @param uu variance of u
   * @param uv covariance of u and v
   * @param vv variance of v
   */
  public double xx(double uu, double uv, double vv) {
    return xu * xu * uu + 2 * xu * xv * uv + xv * xv * vv;
  }

  /**
   * {@return the covariance of x and y, an entry of J C Jᵀ, where (u, v) has the covariance C}
   *
   * @param uu variance of u
   * @param uv covariance of u and v
   * @param vv variance of v
   */
  public double xy(double uu, double uv, double vv) {
    return xu * yu * uu + (xu * yv + xv * yu) * uv + xv * yv * vv;
  }

  /**
   * {@return the variance of y, an entry of J C Jᵀ, where (u, v) has the covariance C}
   *
   * @param uu variance of u
   * @param uv covariance of u and v
   * @param vv variance of v
   */
  public double yy(double uu, double uv, double vv) {
    return yu * yu * uu + 2 * yu * yv * uv + yv * yv * vv;
  }
}
