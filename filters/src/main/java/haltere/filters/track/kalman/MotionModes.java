package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * Interacting multiple models of one target in a plane, of fixed size: straight on, turning, and
 * anything goes, or only the first of them. The same algorithm as {@link
 * haltere.filters.estimation.InteractingMultipleModels} (Blom and Bar-Shalom 1988; Bar-Shalom, Li
 * and Kirubarajan 2001, section 11.6.6), written out for {@link PlaneFilter}, and with one
 * addition: a mode that goes straight knows nothing of a rate of turning, or of an acceleration, so
 * what it hands to a mode that has one is that of a target that has just begun, 0 with its full
 * variance (Granström, Willett and Bar-Shalom 2015, on mixing states of unequal size).
 *
 * <p>Allocates nothing after its construction. Thread rule: not safe for use by two threads at a
 * time.
 */
final class MotionModes {
  private static final int N = PlaneFilter.STATES;
  private static final double LEAST_PROBABILITY = 1e-9;

  /** Share of the speed of a new target by which one that is thrown back may be faster. */
  private static final double RELAUNCH_SHARE = 0.1;

  /** Share of the speed of a new target by which one that is displaced may be faster or slower. */
  private static final double DISPLACED_SHARE = 0.25;

  /** A line is found by this many rows at least. */
  private static final int LEAST_ROWS = 3;

  /** By how much of its standard deviation a line of so few rows is less sure. */
  private static final double ROW_DOUBT = 2;

  /** Of the place of a vehicle whose other line is seen from now on, m². */
  private static final double PLACE_VARIANCE = 25;

  private final MotionNoise noise;
  private final int modes;
  private final PlaneFilter[] filters;
  private final double[] probability;

  /** The probabilities before the last measurement. */
  private final double[] prior;

  private final double[] next;
  private final double[] leave;
  private final double[] weights;

  // Mean and covariance of all modes, as soon as somebody asks for them.
  private final double[] state = new double[N];
  private final double[] covariance = new double[PlaneFilter.ENTRIES];
  private boolean combined;

  MotionModes(MotionNoise noise) {
    this.noise = noise;
    modes = noise.modes();
    filters = new PlaneFilter[modes];
    for (int j = 0; j < modes; j++) {
      filters[j] = new PlaneFilter();
    }
    probability = new double[modes];
    prior = new double[modes];
    next = new double[modes];
    leave = new double[modes];
    weights = new double[modes];
  }

  /** Begins at a place, with a velocity of 0 that is unknown. */
  void launch(double atX, double atY, double xx, double xy, double yy) {
    launch(atX, atY, xx, xy, yy, noise.launchVelocityVariance());
  }

  /** Begins again at a place, with a velocity that is hardly larger than it was. */
  void relaunch(double atX, double atY, double xx, double xy, double yy) {
    double speed = Math.hypot(vx(), vy()) + RELAUNCH_SHARE * noise.launchSpeed();
    launch(atX, atY, xx, xy, yy, speed * speed);
  }

  /** Goes on at a place where it was not expected, with about the velocity that it has. */
  void displace(double atX, double atY, double xx, double xy, double yy) {
    double vx = vx();
    double vy = vy();
    double unsure = DISPLACED_SHARE * noise.launchSpeed();
    launch(atX, atY, xx, xy, yy, unsure * unsure);
    for (int j = 0; j < modes; j++) {
      filters[j].x[2] = vx;
      filters[j].x[3] = vy;
    }
  }

  /**
   * Begins with a line across the road whose place and speed along it are known. Of few rows one
   * may have been passed by another line, which the fit does not know of.
   */
  void launchLine(LineSearch found, double varianceX, double varianceVx) {
    double more = doubt(found);
    launch(found.xM, found.yM, varianceX, 0, more * found.varianceY, varianceVx);
    for (int j = 0; j < modes; j++) {
      filters[j].setAlong(found.vyMS, more * found.covarianceYvy, more * found.varianceVy);
    }
    combined = false;
  }

  /** By how much the variances of a line are larger than the fit to its rows says. */
  private static double doubt(LineSearch found) {
    double few = (double) LEAST_ROWS / found.rows;
    double doubt = 1 + ROW_DOUBT * few * few;
    return doubt * doubt;
  }

  /** Goes on with another line of the same vehicle, which tells of its speed as well. */
  void rejoinLine(LineSearch found, double varianceX) {
    shift(0, PLACE_VARIANCE);
    if (!Double.isNaN(innovate(found.xM, found.yM, varianceX, 0, found.varianceY))) {
      correct();
    }
    for (int j = 0; j < modes; j++) {
      filters[j].correctAlong(found.vyMS, doubt(found) * found.varianceVy);
    }
    combined = false;
  }

  /** Goes on along the road in one direction only, 1 or -1, or stands. */
  void goOnly(int forward) {
    for (int j = 0; j < modes; j++) {
      double[] x = filters[j].x;
      x[3] = forward * Math.max(0, forward * x[3]);
      x[4] = x[3] == 0 ? forward * Math.max(0, forward * x[4]) : x[4];
    }
    combined = false;
  }

  /** Moves the place along the road, by what is known with a variance. */
  void shift(double byY, double variance) {
    for (int j = 0; j < modes; j++) {
      filters[j].shift(byY, variance);
    }
    combined = false;
  }

  private void launch(
      double atX, double atY, double xx, double xy, double yy, double velocityVariance) {
    for (int j = 0; j < modes; j++) {
      filters[j].launch(atX, atY, xx, xy, yy, velocityVariance, noise.rateVariance(j));
      probability[j] = 1.0 / modes;
    }
    combined = false;
  }

  void copyFrom(MotionModes other) {
    for (int j = 0; j < modes; j++) {
      filters[j].copyFrom(other.filters[j]);
      probability[j] = other.probability[j];
    }
    combined = false;
  }

  /**
   * Takes over what another one predicts.
   *
   * @param other stays as it is
   * @param dtS seconds, not negative
   * @param noiseFactor the process noise is this many times the usual one
   */
  void predictFrom(MotionModes other, double dtS, double noiseFactor) {
    if (modes > 1 && dtS > 0) {
      mixFrom(other, dtS);
      combined = false;
    } else {
      copyFrom(other);
    }
    coast(dtS, noiseFactor);
  }

  /** Predicts without a thought that the target may change its way of moving. */
  void coast(double dtS, double noiseFactor) {
    if (!(dtS > 0)) {
      return;
    }
    for (int j = 0; j < modes; j++) {
      AlongAcceleration along = noise.along(j);
      if (along != null) {
        along.evolve(filters[j], dtS);
        along.addNoise(filters[j], dtS, noise.acceleration(j) * noiseFactor);
        continue;
      }
      filters[j].evolve(dtS);
      if (noise.perStep()) {
        filters[j].addStepNoise(noise.acceleration(j) * noiseFactor);
      } else {
        filters[j].addNoise(
            dtS, noise.acceleration(j) * noiseFactor, noise.turns(j) ? noise.turn() : 0);
      }
    }
    combined = false;
  }

  /** Compares a measurement with all modes; gives back the least normalised innovation squared. */
  double innovate(double zX, double zY, double xx, double xy, double yy) {
    double least = Double.POSITIVE_INFINITY;
    for (int j = 0; j < modes; j++) {
      if (!filters[j].innovate(zX, zY, xx, xy, yy)) {
        return Double.NaN;
      }
      least = Math.min(least, filters[j].nis());
      prior[j] = probability[j];
    }
    return least;
  }

  /** Logarithm of the likelihood of what {@link #innovate} has compared. */
  double logLikelihood() {
    double greatest = Double.NEGATIVE_INFINITY;
    for (int j = 0; j < modes; j++) {
      greatest = Math.max(greatest, filters[j].logLikelihood());
    }
    double sum = 0;
    for (int j = 0; j < modes; j++) {
      sum += probability[j] * Math.exp(filters[j].logLikelihood() - greatest);
    }
    return greatest + Math.log(sum);
  }

  /** Takes in what {@link #innovate} has compared. */
  void correct() {
    if (modes > 1) {
      weigh();
    }
    for (int j = 0; j < modes; j++) {
      filters[j].correct();
    }
    combined = false;
  }

  /** Gives each mode the probability that it has once a measurement is known. */
  private void weigh() {
    double least = Double.POSITIVE_INFINITY;
    for (int j = 0; j < modes; j++) {
      least = Math.min(least, filters[j].nis());
    }
    double sum = 0;
    for (int j = 0; j < modes; j++) {
      PlaneFilter filter = filters[j];
      next[j] =
          probability[j] * Math.exp(0.5 * (least - filter.nis())) / Math.sqrt(filter.determinant());
      sum += next[j];
    }
    double kept = 0;
    for (int j = 0; j < modes; j++) {
      probability[j] = Math.max(LEAST_PROBABILITY, next[j] / sum);
      kept += probability[j];
    }
    for (int j = 0; j < modes; j++) {
      probability[j] /= kept;
    }
  }

  /** What all modes together had expected of what {@link #innovate} has compared. */
  void combineInnovations(CombinedInnovation into) {
    into.of(filters, prior);
  }

  /** The mode that is the most probable. */
  PlaneFilter likeliest() {
    int best = 0;
    for (int j = 1; j < modes; j++) {
      best = probability[j] > probability[best] ? j : best;
    }
    return filters[best];
  }

  double modeProbability(int mode) {
    return probability[mode];
  }

  double x() {
    combine();
    return state[0];
  }

  double y() {
    combine();
    return state[1];
  }

  double vx() {
    combine();
    return state[2];
  }

  double vy() {
    combine();
    return state[3];
  }

  double covariance(int row, int column) {
    combine();
    return covariance[PlaneFilter.place(row, column)];
  }

  private void mixFrom(MotionModes other, double dtS) {
    // All but the last are left at the same rate.
    double usual = noise.leave(0, dtS);
    for (int i = 0; i < modes; i++) {
      leave[i] = i < modes - 1 ? usual : noise.leave(i, dtS);
    }
    for (int j = 0; j < modes; j++) {
      double sum = 0;
      for (int i = 0; i < modes; i++) {
        weights[i] = other.probability[i] * noise.transition(i, j, leave[i]);
        sum += weights[i];
      }
      for (int i = 0; i < modes; i++) {
        weights[i] /= sum;
      }
      next[j] = sum;
      mixture(other.filters, filters[j].x, filters[j].p, noise.rateVariance(j));
    }
    System.arraycopy(next, 0, probability, 0, modes);
  }

  private void combine() {
    if (combined) {
      return;
    }
    combined = true;
    if (modes == 1) {
      System.arraycopy(filters[0].x, 0, state, 0, N);
      System.arraycopy(filters[0].p, 0, covariance, 0, PlaneFilter.ENTRIES);
      return;
    }
    System.arraycopy(probability, 0, weights, 0, modes);
    mixture(filters, state, covariance, 0);
  }

  /**
   * Mean and covariance of the modes. A rate is mixed only where one is wanted: the variance of an
   * unknown one, or 0 for none.
   */
  private void mixture(PlaneFilter[] of, double[] mean, double[] spread, double unknownRate) {
    boolean rates = unknownRate > 0;
    Arrays.fill(mean, 0);
    Arrays.fill(spread, 0);
    for (int i = 0; i < modes; i++) {
      double w = weights[i];
      double[] x = of[i].x;
      mean[0] += w * x[0];
      mean[1] += w * x[1];
      mean[2] += w * x[2];
      mean[3] += w * x[3];
      mean[4] += rates ? w * x[4] : 0;
    }
    for (int i = 0; i < modes; i++) {
      addSpread(of[i], mean, weights[i], spread, rates);
      if (rates && noise.rateVariance(i) == 0) {
        spread[PlaneFilter.ENTRIES - 1] += weights[i] * unknownRate;
      }
    }
  }

  /** Adds the weight times P + (x - mean) (x - mean)ᵀ; in the order of the entries of P. */
  private static void addSpread(
      PlaneFilter of, double[] mean, double weight, double[] spread, boolean rates) {
    double[] x = of.x;
    double[] p = of.p;
    double d0 = x[0] - mean[0];
    double d1 = x[1] - mean[1];
    double d2 = x[2] - mean[2];
    double d3 = x[3] - mean[3];
    spread[0] += weight * (p[0] + d0 * d0);
    spread[1] += weight * (p[1] + d0 * d1);
    spread[2] += weight * (p[2] + d0 * d2);
    spread[3] += weight * (p[3] + d0 * d3);
    spread[4] += weight * (p[4] + d1 * d1);
    spread[5] += weight * (p[5] + d1 * d2);
    spread[6] += weight * (p[6] + d1 * d3);
    spread[7] += weight * (p[7] + d2 * d2);
    spread[8] += weight * (p[8] + d2 * d3);
    spread[9] += weight * (p[9] + d3 * d3);
    if (rates) {
      double d4 = x[4] - mean[4];
      spread[10] += weight * (p[10] + d0 * d4);
      spread[11] += weight * (p[11] + d1 * d4);
      spread[12] += weight * (p[12] + d2 * d4);
      spread[13] += weight * (p[13] + d3 * d4);
      spread[14] += weight * (p[14] + d4 * d4);
    }
  }
}
