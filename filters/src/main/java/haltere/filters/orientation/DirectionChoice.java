package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.List;

/**
 * Resolves head and tail over a whole track: the path through the signs s_t = ±1 with the least
 * cost (Viterbi 1967), with the cost of a step as in Straw et al. (2011)
 *
 * <pre>
 * w ∠(s_t u_t, v̂_t) + (1 − w) ∠(s_t u_t, s_{t−1} u_{t−1}) + (1 − w) ∠(s_t u_t, up)
 * </pre>
 *
 * <p>v̂ is the direction of travel, tilted up by up to 45°, since insects fly with their heads up.
 * Unknown terms are omitted. In Straw et al. w = min(0.9, 0.5 · speed in m/s), which is near 0 for
 * slow bodies; the default is {@link #weightOf} a speed and its standard deviation.
 */
final class DirectionChoice {
  private static final double TIP_RAD = Math.toRadians(45);
  private static final double MAX_WEIGHT = 0.9;
  private static final double[] UP = {0, 0, 1};

  private DirectionChoice() {}

  /** Weight of the direction of travel as in Straw et al. (2011). */
  static double originalWeight(double speedMS) {
    return Math.min(MAX_WEIGHT, 0.5 * speedMS);
  }

  /** Weight of the direction of travel by the speed in standard deviations, half at 3. */
  static double weightOf(double speedMS, double sdMS) {
    double sigmas = speedMS / sdMS;
    return sdMS > 0 ? MAX_WEIGHT * sigmas * sigmas / (sigmas * sigmas + 9) : MAX_WEIGHT;
  }

  /**
   * Chooses the signs.
   *
   * @param axes unit vectors, of either sign
   * @param velocities of the body, metres a second, of any length
   * @param weights w of each time
   * @param linked whether each axis continues the previous one
   * @return whether each axis is to be reversed
   */
  static boolean[] flips(
      List<double[]> axes, List<double[]> velocities, double[] weights, boolean[] linked) {
    int count = axes.size();
    byte[][] from = new byte[count][2];
    double[] cost = new double[2];
    for (int t = 0; t < count; t++) {
      double[] u = axes.get(t);
      double[] travel = tipped(velocities.get(t));
      double w = weights[t];
      double alongTravel = travel == null ? 0 : Vectors.angle(u, travel);
      double alongUp = Vectors.angle(u, UP);
      double step = t > 0 && linked[t] ? Vectors.angle(u, axes.get(t - 1)) : Double.NaN;
      double[] next = new double[2];
      for (int sign = 0; sign < 2; sign++) {
        double own =
            (travel == null ? 0 : w * (sign == 0 ? alongTravel : Math.PI - alongTravel))
                + (1 - w) * (sign == 0 ? alongUp : Math.PI - alongUp);
        double same = cost[sign] + (Double.isNaN(step) ? 0 : (1 - w) * step);
        double other = cost[1 - sign] + (Double.isNaN(step) ? 0 : (1 - w) * (Math.PI - step));
        from[t][sign] = (byte) (same <= other ? sign : 1 - sign);
        next[sign] = own + Math.min(same, other);
      }
      cost = next;
    }
    boolean[] flips = new boolean[count];
    int sign = count > 0 && cost[1] < cost[0] ? 1 : 0;
    for (int t = count - 1; t >= 0; t--) {
      flips[t] = sign == 1;
      sign = from[t][sign];
    }
    return flips;
  }

  /** The direction of travel, up to 45 degrees nearer to up; null if there is none. */
  private static double[] tipped(double[] velocity) {
    double[] direction = velocity.clone();
    if (!Vectors.normalise(direction)) {
      return null;
    }
    double toUp = Vectors.angle(direction, UP);
    double[] side = new double[3];
    for (int k = 0; k < 3; k++) {
      side[k] = UP[k] - Math.cos(toUp) * direction[k];
    }
    if (!Vectors.normalise(side)) {
      return direction;
    }
    double tip = Math.min(TIP_RAD, toUp);
    for (int k = 0; k < 3; k++) {
      direction[k] = Math.cos(tip) * direction[k] + Math.sin(tip) * side[k];
    }
    return direction;
  }
}
