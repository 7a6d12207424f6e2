package haltere.core.simulation.internal.road;

/**
 * The place of a vehicle across the road as a function of time: a lane, and perhaps an excursion to
 * another one and back, without a jolt in speed or acceleration.
 *
 * <p>Thread rule: immutable.
 *
 * @param laneM place in the lane, metres
 * @param excursionM how far to the right the excursion goes, metres
 * @param outS when it begins
 * @param backS when the way back begins
 * @param changeS how long it takes to change the lane
 */
record Steering(double laneM, double excursionM, double outS, double backS, double changeS) {
  static Steering straight(double laneM) {
    return new Steering(laneM, 0, 0, 0, 1);
  }

  double position(double seconds) {
    if (excursionM == 0) {
      return laneM;
    }
    return laneM
        + excursionM * (share((seconds - outS) / changeS) - share((seconds - backS) / changeS));
  }

  double speed(double seconds) {
    if (excursionM == 0) {
      return 0;
    }
    return excursionM
        / changeS
        * (slope((seconds - outS) / changeS) - slope((seconds - backS) / changeS));
  }

  private static double share(double p) {
    double q = Math.max(0, Math.min(1, p));
    return q * q * q * (10 - q * (15 - 6 * q));
  }

  private static double slope(double p) {
    double q = Math.max(0, Math.min(1, p));
    return 30 * q * q * (1 - q) * (1 - q);
  }
}
