package haltere.filters.orientation.internal.axis;

/**
 * State of a hypothesis of {@link SphereFilter} at one time.
 *
 * @param u the axis
 * @param e1 first tangent direction
 * @param e2 second tangent direction, u × e1
 * @param va velocity along e1, per second
 * @param vb velocity along e2
 * @param p covariance of the error, order a, ȧ, b, ḃ, sixteen entries
 */
public record AxisState(double[] u, double[] e1, double[] e2, double va, double vb, double[] p) {
  /** {@return the velocity of the axis' tip, per second} */
  public double[] tipVelocity() {
    double[] tip = new double[3];
    for (int i = 0; i < 3; i++) {
      tip[i] = va * e1[i] + vb * e2[i];
    }
    return tip;
  }
}
