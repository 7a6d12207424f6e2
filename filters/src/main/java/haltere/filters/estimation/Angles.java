package haltere.filters.estimation;

/** Differences of angles, wrapped. Wrap the innovation, never the state. */
public final class Angles {
  private static final double TWO_PI = 2 * Math.PI;

  private Angles() {}

  /**
   * The same angle in (−π, π].
   *
   * @param angle radians
   * @return radians; NaN for NaN and infinities
   */
  public static double wrapPi(double angle) {
    if (angle > -Math.PI && angle <= Math.PI) {
      return angle;
    }
    double wrapped = Math.IEEEremainder(angle, TWO_PI);
    return wrapped <= -Math.PI ? Math.PI : wrapped;
  }

  /**
   * The same angle in [0, 2π).
   *
   * @param angle radians
   * @return radians; NaN for NaN and infinities
   */
  public static double wrapTwoPi(double angle) {
    double turns = angle / TWO_PI;
    double wrapped = (turns - Math.floor(turns)) * TWO_PI;
    return wrapped >= TWO_PI ? 0 : wrapped;
  }

  /**
   * The same direction of an undirected line, in (−π/2, π/2]: for angles known modulo π only.
   *
   * @param angle radians
   * @return radians; NaN for NaN and infinities
   */
  public static double wrapHalfPi(double angle) {
    return 0.5 * wrapPi(2 * angle);
  }
}
