package haltere.filters.track;

import java.util.Arrays;

/**
 * Interacting multiple models of one target in a plane, of fixed size: straight on, turning, and
 * anything goes, or only the first of them. The same algorithm as {@link
 * haltere.filters.estimation.InteractingMultipleModels} (Blom and Bar-Shalom 1988; Bar-Shalom, Li
 * and Kirubarajan 2001, section 11.6.6), written out for {@link PlaneFilter}, and with one
 * addition: a mode that goes straight knows nothing of a turn rate, so what it hands to a mode that
 * turns is the turn rate of a target that has just begun to turn, 0 with its full variance
 * (Granström, Willett and Bar-Shalom 2015, on mixing states of unequal size).
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

  private final MotionNoise noise;
  private final int modes;
  private final PlaneFilter[] filters;
  private final PlaneFilter[] mixed;
  private final double[] probability;
  private final double[] next;
  private final double[] leave;
  private final double[] weights;
  private final double[] state = new double[N];
  private final double[] covariance = new double[N * N];

  MotionModes(MotionNoise noise) {
    this.noise = noise;
    modes = noise.modes();
    filters = new PlaneFilter[modes];
    mixed = new PlaneFilter[modes];
    for (int j = 0; j < modes; j++) {
      filters[j] = new PlaneFilter();
      mixed[j] = new PlaneFilter();
    }
    probability = new double[modes];
    next = new double[modes];
    leave = new double[modes];
    weights = new double[modes * modes];
  }

  /** Begins at a place, with a velocity of 0 that is unknown. */
  void launch(double atX, double atY, double xx, double xy, double yy) {
    launch(atX, atY, xx, xy, yy, noise.launchVelocityVariance());
  }

  /** Begins again at a place, with a velocity that is hardly larger than it was. */
  void relaunch(double atX, double atY, double xx, double xy, double yy) {
    double speed = Math.hypot(state[2], state[3]) + RELAUNCH_SHARE * noise.launchSpeed();
    launch(atX, atY, xx, xy, yy, speed * speed);
  }

  /** Goes on at a place where it was not expected, with about the velocity that it has. */
  void displace(double atX, double atY, double xx, double xy, double yy) {
    double vx = state[2];
    double vy = state[3];
    double unsure = DISPLACED_SHARE * noise.launchSpeed();
    launch(atX, atY, xx, xy, yy, unsure * unsure);
    for (int j = 0; j < modes; j++) {
      filters[j].x[2] = vx;
      filters[j].x[3] = vy;
    }
    combine();
  }

  private void launch(
      double atX, double atY, double xx, double xy, double yy, double velocityVariance) {
    for (int j = 0; j < modes; j++) {
      filters[j].launch(
          atX, atY, xx, xy, yy, velocityVariance, noise.turns(j) ? noise.turnRateVariance() : 0);
      probability[j] = 1.0 / modes;
    }
    combine();
  }

  void copyFrom(MotionModes other) {
    for (int j = 0; j < modes; j++) {
      filters[j].copyFrom(other.filters[j]);
    }
    System.arraycopy(other.probability, 0, probability, 0, modes);
    System.arraycopy(other.state, 0, state, 0, N);
    System.arraycopy(other.covariance, 0, covariance, 0, N * N);
  }

  /**
   * Predicts.
   *
   * @param dtS seconds, not negative
   * @param noiseFactor the process noise is this many times the usual one
   */
  void predict(double dtS, double noiseFactor) {
    if (modes > 1 && dtS > 0) {
      mix(dtS);
    }
    coast(dtS, noiseFactor);
  }

  /** Predicts without a thought that the target may change its way of moving. */
  void coast(double dtS, double noiseFactor) {
    for (int j = 0; j < modes; j++) {
      filters[j].evolve(dtS);
      if (noise.perStep()) {
        filters[j].addStepNoise(noise.acceleration(j) * noiseFactor);
      } else {
        filters[j].addNoise(
            dtS, noise.acceleration(j) * noiseFactor, noise.turns(j) ? noise.turn() : 0);
      }
    }
    combine();
  }

  /** Compares a measurement with all modes; gives back the least normalised innovation squared. */
  double innovate(double zX, double zY, double xx, double xy, double yy) {
    double least = Double.POSITIVE_INFINITY;
    for (int j = 0; j < modes; j++) {
      if (!filters[j].innovate(zX, zY, xx, xy, yy)) {
        return Double.NaN;
      }
      least = Math.min(least, filters[j].nis());
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
      next[j] = probability[j] * Math.exp(filters[j].logLikelihood() - greatest);
      sum += next[j];
    }
    return greatest + Math.log(sum);
  }

  /** Takes in what {@link #innovate} has compared. */
  void correct() {
    if (modes > 1) {
      logLikelihood();
      double sum = 0;
      for (int j = 0; j < modes; j++) {
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
    for (int j = 0; j < modes; j++) {
      filters[j].correct();
    }
    combine();
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
    return state[0];
  }

  double y() {
    return state[1];
  }

  double vx() {
    return state[2];
  }

  double vy() {
    return state[3];
  }

  double covariance(int row, int column) {
    return covariance[row * N + column];
  }

  private void mix(double dtS) {
    for (int i = 0; i < modes; i++) {
      leave[i] = noise.leave(i, dtS);
    }
    for (int j = 0; j < modes; j++) {
      double sum = 0;
      for (int i = 0; i < modes; i++) {
        double weight = probability[i] * noise.transition(i, j, leave[i]);
        weights[j * modes + i] = weight;
        sum += weight;
      }
      next[j] = sum;
      for (int i = 0; i < modes; i++) {
        weights[j * modes + i] /= sum;
      }
      mixture(j * modes, mixed[j].x, mixed[j].p, noise.turns(j) ? noise.turnRateVariance() : -1);
    }
    for (int j = 0; j < modes; j++) {
      filters[j].copyFrom(mixed[j]);
      probability[j] = next[j];
    }
  }

  private void combine() {
    if (modes == 1) {
      System.arraycopy(filters[0].x, 0, state, 0, N);
      System.arraycopy(filters[0].p, 0, covariance, 0, N * N);
      return;
    }
    System.arraycopy(probability, 0, weights, 0, modes);
    mixture(0, state, covariance, -1);
  }

  /**
   * Mean and covariance of the modes. A turn rate is mixed only where one is wanted: the variance
   * of an unknown one, or less than 0 for none.
   */
  private void mixture(int from, double[] mean, double[] spread, double unknownTurnRate) {
    Arrays.fill(mean, 0);
    Arrays.fill(spread, 0);
    boolean turns = unknownTurnRate >= 0;
    int size = turns ? N : N - 1;
    for (int i = 0; i < modes; i++) {
      double w = weights[from + i];
      for (int a = 0; a < size; a++) {
        mean[a] += w * filters[i].x[a];
      }
    }
    for (int i = 0; i < modes; i++) {
      double w = weights[from + i];
      double[] x = filters[i].x;
      double[] p = filters[i].p;
      for (int a = 0; a < size; a++) {
        double apart = w * (x[a] - mean[a]);
        for (int b = a; b < size; b++) {
          spread[a * N + b] += w * p[a * N + b] + apart * (x[b] - mean[b]);
        }
      }
      if (turns && !noise.turns(i)) {
        spread[N * N - 1] += w * unknownTurnRate;
      }
    }
    for (int a = 1; a < size; a++) {
      for (int b = 0; b < a; b++) {
        spread[a * N + b] = spread[b * N + a];
      }
    }
  }
}
