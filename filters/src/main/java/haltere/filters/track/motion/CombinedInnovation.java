package haltere.filters.track.motion;

/**
 * What several models together have expected of a measurement: the mean and the covariance of the
 * mixture of what each has, weighted by the probability that each had before it. If the models and
 * their probabilities are right, the mean of its normalised square is the number of coordinates.
 *
 * <p>Units are those of the plane, pixels or metres. Thread rule: immutable.
 *
 * @param x by how much the measured place was off, on average
 * @param y by how much the measured place was off, on average
 * @param xx entry of the covariance
 * @param xy entry of the covariance
 * @param yy entry of the covariance
 */
public record CombinedInnovation(double x, double y, double xx, double xy, double yy) {
  /** Combines the last comparisons of some models. */
  static CombinedInnovation of(PlaneFilter[] models, double[] probability) {
    double x = 0;
    double y = 0;
    for (int j = 0; j < models.length; j++) {
      x += probability[j] * models[j].innovationX();
      y += probability[j] * models[j].innovationY();
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (int j = 0; j < models.length; j++) {
      double dx = models[j].innovationX() - x;
      double dy = models[j].innovationY() - y;
      xx += probability[j] * (models[j].innovationXx() + dx * dx);
      xy += probability[j] * (models[j].innovationXy() + dx * dy);
      yy += probability[j] * (models[j].innovationYy() + dy * dy);
    }
    return new CombinedInnovation(x, y, xx, xy, yy);
  }

  /**
   * Normalised innovation squared.
   *
   * @return of two degrees of freedom
   */
  public double nis() {
    return (yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy);
  }
}
