package haltere.filters.track.motion;

/**
 * A vehicle that brakes or speeds up along the road: the fifth state of a {@link PlaneFilter} is
 * the acceleration along y, which keeps for some time and then goes back to 0 (Singer 1970;
 * Bar-Shalom, Li and Kirubarajan 2001, section 8.2.2), and across the road the acceleration is
 * white. A vehicle that brakes stands in the end and does not go backwards.
 *
 * <p>Thread rule: immutable.
 *
 * @param sdMS2 standard deviation of the acceleration along the road, m/s²
 * @param keptS the time constant with which it is forgotten, seconds
 */
record AlongAcceleration(double sdMS2, double keptS) {
  double variance() {
    return sdMS2 * sdMS2;
  }

  /** Evolves without noise. */
  void evolve(PlaneFilter filter, double dtS) {
    double[] x = filter.x;
    double[] p = filter.p;
    p[10] += dtS * p[12];
    p[11] += dtS * p[13];
    filter.goStraight(dtS);
    double kept = Math.exp(-dtS / keptS);
    double toSpeed = keptS * (1 - kept);
    double toPlace = keptS * (dtS - toSpeed);
    move(x, dtS, kept, toSpeed, toPlace);
    // P ← G P Gᵀ, where G adds the acceleration to place and speed.
    double p14 = p[11];
    double p34 = p[13];
    double p44 = p[14];
    p[1] += toPlace * p[10];
    p[3] += toSpeed * p[10];
    p[5] += toPlace * p[12];
    p[8] += toSpeed * p[12];
    p[4] += toPlace * (2 * p14 + toPlace * p44);
    p[6] += toPlace * p34 + toSpeed * (p14 + toPlace * p44);
    p[9] += toSpeed * (2 * p34 + toSpeed * p44);
    p[10] *= kept;
    p[12] *= kept;
    p[11] = kept * (p14 + toPlace * p44);
    p[13] = kept * (p34 + toSpeed * p44);
    p[14] = kept * kept * p44;
  }

  /** Goes on to the end of the step, or as far as it takes to stand; y has gone straight on. */
  private static void move(double[] x, double dtS, double kept, double toSpeed, double toPlace) {
    double speed = x[3];
    double gained = toSpeed * x[4];
    if (speed * x[4] < 0 && Math.abs(gained) > Math.abs(speed)) {
      // About as if it braked evenly until it stands.
      double standsS = dtS * speed / -gained;
      x[1] += speed * (standsS / 2 - dtS);
      x[3] = 0;
      x[4] = 0;
    } else {
      x[1] += toPlace * x[4];
      x[3] = speed + gained;
      x[4] *= kept;
    }
  }

  /** Adds what changes of the acceleration do, and white acceleration of a density across. */
  void addNoise(PlaneFilter filter, double dtS, double acrossDensity) {
    double[] p = filter.p;
    double q = acrossDensity * dtS;
    p[0] += q * dtS * dtS / 3;
    p[2] += q * dtS / 2;
    p[7] += q;
    // A white jerk of the density that keeps the variance of the acceleration as it is.
    double kept = Math.exp(-dtS / keptS);
    double jerk = variance() * (1 - kept * kept);
    p[14] += jerk;
    p[13] += jerk * dtS / 2;
    p[11] += jerk * dtS * dtS / 6;
    p[9] += jerk * dtS * dtS / 3;
    p[6] += jerk * dtS * dtS * dtS / 8;
    p[4] += jerk * dtS * dtS * dtS * dtS / 20;
  }
}
