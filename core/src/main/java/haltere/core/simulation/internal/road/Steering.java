package haltere.core.simulation.internal.road;

/**
 * The lateral position of a vehicle as a function of time: a lane, and optionally an excursion to
 * another one and back, with continuous speed and acceleration.
 *
 * <p>Thread rule: immutable.
 *
 * @param laneM position in its lane, metres to the right
 * @param excursionM amount of the excursion, metres to the right
 * @param outS start of the excursion, seconds
 * @param backS start of the return, seconds
 * @param changeS duration of a lane change, seconds
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
