package haltere.filters.track.kalman;

/**
 * What several models together have expected of a measurement: the mean and the covariance of the
 * mixture of what each has, weighted by the probability that each had before it. If the models and
 * their probabilities are right, the mean of its normalised square is the number of coordinates.
 *
 * <p>Thread rule: that of its owner.
 */
final class CombinedInnovation {
  double x;
  double y;
  double xx;
  double xy;
  double yy;

  /** Combines the last comparisons of some models. */
  void of(PlaneFilter[] models, double[] probability) {
    x = 0;
    y = 0;
    for (int j = 0; j < models.length; j++) {
      x += probability[j] * models[j].innovationX();
      y += probability[j] * models[j].innovationY();
    }
    xx = 0;
    xy = 0;
    yy = 0;
    for (int j = 0; j < models.length; j++) {
      double dx = models[j].innovationX() - x;
      double dy = models[j].innovationY() - y;
      xx += probability[j] * (models[j].innovationXx() + dx * dx);
      xy += probability[j] * (models[j].innovationXy() + dx * dy);
      yy += probability[j] * (models[j].innovationYy() + dy * dy);
    }
  }

  /** Normalised innovation squared, two degrees of freedom. */
  double nis() {
    return (yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy);
  }
}
