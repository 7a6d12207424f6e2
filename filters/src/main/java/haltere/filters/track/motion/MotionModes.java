package haltere.filters.track.motion;

/**
 * Interacting multiple models of one target in a plane, of fixed size: straight on, turning, and
 * anything goes, or only the first of them. The same algorithm as {@link
 * haltere.filters.estimation.InteractingMultipleModels} (Blom and Bar-Shalom 1988; Bar-Shalom, Li
 * and Kirubarajan 2001, section 11.6.6), written out for {@code PlaneFilter}, and with one
 * addition: a mode that goes straight knows nothing of a rate of turning, or of an acceleration, so
 * what it hands to a mode that has one is that of a target that has just begun, 0 with its full
 * variance (Granström, Willett and Bar-Shalom 2015, on mixing states of unequal size). Three modes
 * are not mixed at every prediction, see {@code MotionNoise}.
 *
 * <p>Units are those of the plane, pixels or metres, with seconds. On a road y is along it.
 *
 * <p>Allocates nothing after its construction. Thread rule: not safe for use by two threads at a
 * time.
 */
public final class MotionModes {
  private static final double LEAST_PROBABILITY = 1e-9;

  /** Share of the speed of a new target by which one that is thrown back may be faster. */
  private static final double RELAUNCH_SHARE = 0.1;

  /** Share of the speed of a new target by which one that is displaced may be faster or slower. */
  private static final double DISPLACED_SHARE = 0.25;

  private final MotionNoise noise;
  private final int modes;
  private final PlaneFilter[] filters;
  private final double[] probability;

  /** The probabilities before the last measurement. */
  private final double[] prior;

  private final double[] next;
  private final ModeMixture mixture;

  /** Mean of all modes, as soon as somebody asks for it. */
  private final double[] state = new double[PlaneFilter.STATES];

  private boolean combined;

  /** Time since modes were mixed, seconds. */
  private double unmixedS;

  /**
   * Modes that have yet to be launched.
   *
   * @param noise how a target moves
   */
  public MotionModes(MotionNoise noise) {
    this.noise = noise;
    modes = noise.modes();
    filters = new PlaneFilter[modes];
    for (int j = 0; j < modes; j++) {
      filters[j] = new PlaneFilter();
    }
    probability = new double[modes];
    prior = new double[modes];
    next = new double[modes];
    mixture = new ModeMixture(noise);
  }

  /**
   * Begins at a place, with a velocity of 0 that is unknown.
   *
   * @param atX measured place
   * @param atY measured place
   * @param xx entry of its covariance
   * @param xy entry of its covariance
   * @param yy entry of its covariance
   */
  public void launch(double atX, double atY, double xx, double xy, double yy) {
    launch(atX, atY, xx, xy, yy, noise.launchVelocityVariance());
  }

  /**
   * Begins again at a place, with a velocity that is hardly larger than it was.
   *
   * @param atX measured place
   * @param atY measured place
   * @param xx entry of its covariance
   * @param xy entry of its covariance
   * @param yy entry of its covariance
   */
  public void relaunch(double atX, double atY, double xx, double xy, double yy) {
    double speed = Math.hypot(vx(), vy()) + RELAUNCH_SHARE * noise.launchSpeed();
    launch(atX, atY, xx, xy, yy, speed * speed);
  }

  /**
   * Goes on at a place where it was not expected, with about the velocity that it has.
   *
   * @param atX measured place
   * @param atY measured place
   * @param xx entry of its covariance
   * @param xy entry of its covariance
   * @param yy entry of its covariance
   */
  public void displace(double atX, double atY, double xx, double xy, double yy) {
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
   * Sets what is known of the velocity along y.
   *
   * @param velocity along y
   * @param covarianceYvy its covariance with the place along y
   * @param variance its variance
   */
  public void setAlong(double velocity, double covarianceYvy, double variance) {
    for (int j = 0; j < modes; j++) {
      filters[j].setAlong(velocity, covarianceYvy, variance);
    }
    combined = false;
  }

  /**
   * Takes in a measured velocity along y, whatever the modes.
   *
   * @param velocity along y
   * @param variance its variance
   */
  public void correctAlong(double velocity, double variance) {
    for (int j = 0; j < modes; j++) {
      filters[j].correctAlong(velocity, variance);
    }
    combined = false;
  }

  /**
   * Goes on along y in one direction only, or stands.
   *
   * @param forward 1 or -1
   */
  public void goOnly(int forward) {
    for (int j = 0; j < modes; j++) {
      double[] x = filters[j].x;
      x[3] = forward * Math.max(0, forward * x[3]);
      x[4] = x[3] == 0 ? forward * Math.max(0, forward * x[4]) : x[4];
    }
    combined = false;
  }

  /**
   * Moves the place along y.
   *
   * @param byY by so much
   * @param variance of how far that is
   */
  public void shift(double byY, double variance) {
    for (int j = 0; j < modes; j++) {
      filters[j].shift(byY, variance);
    }
    combined = false;
  }

  /**
   * Begins at a place, with a velocity of 0 of a variance.
   *
   * @param atX measured place
   * @param atY measured place
   * @param xx entry of its covariance
   * @param xy entry of its covariance
   * @param yy entry of its covariance
   * @param velocityVariance of each velocity
   */
  public void launch(
      double atX, double atY, double xx, double xy, double yy, double velocityVariance) {
    for (int j = 0; j < modes; j++) {
      filters[j].launch(atX, atY, xx, xy, yy, velocityVariance, noise.rateVariance(j));
      probability[j] = 1.0 / modes;
    }
    unmixedS = 0;
    combined = false;
  }

  /**
   * Takes over what another one knows.
   *
   * @param other of the same noise, stays as it is
   */
  public void copyFrom(MotionModes other) {
    for (int j = 0; j < modes; j++) {
      filters[j].copyFrom(other.filters[j]);
      probability[j] = other.probability[j];
    }
    unmixedS = other.unmixedS;
    combined = false;
  }

  /**
   * Takes over what another one predicts.
   *
   * @param other stays as it is
   * @param dtS seconds, not negative
   * @param noiseFactor the process noise is this many times the usual one
   */
  public void predictFrom(MotionModes other, double dtS, double noiseFactor) {
    double goneS = other.unmixedS + dtS;
    if (modes > 1 && dtS > 0 && goneS >= noise.mixedEveryS()) {
      mixFrom(other, goneS);
      unmixedS = 0;
      coast(dtS, noiseFactor);
    } else {
      coastFrom(other, dtS, noiseFactor);
      unmixedS = goneS;
    }
  }

  /**
   * Predicts without a thought that the target may change its way of moving.
   *
   * @param dtS seconds, not negative
   * @param noiseFactor the process noise is this many times the usual one
   */
  public void coast(double dtS, double noiseFactor) {
    coastFrom(this, dtS, noiseFactor);
  }

  /**
   * Becomes what another one predicts without a thought that the target may change its way of
   * moving.
   *
   * @param other stays as it is
   * @param dtS seconds, not negative
   * @param noiseFactor the process noise is this many times the usual one
   */
  public void coastFrom(MotionModes other, double dtS, double noiseFactor) {
    if (!(dtS > 0)) {
      copyFrom(other);
      return;
    }
    unmixedS = other.unmixedS;
    for (int j = 0; j < modes; j++) {
      probability[j] = other.probability[j];
      AlongAcceleration along = noise.along(j);
      if (along != null) {
        filters[j].copyFrom(other.filters[j]);
        along.evolve(filters[j], dtS);
        along.addNoise(filters[j], dtS, noise.acceleration(j) * noiseFactor);
        continue;
      }
      filters[j].evolveFrom(other.filters[j], dtS);
      if (noise.perStep()) {
        filters[j].addStepNoise(noise.acceleration(j) * noiseFactor);
      } else {
        filters[j].addNoise(
            dtS, noise.acceleration(j) * noiseFactor, noise.turns(j) ? noise.turn() : 0);
      }
    }
    combined = false;
  }

  /**
   * Compares a measurement with all modes.
   *
   * @param zX measured place
   * @param zY measured place
   * @param xx entry of its covariance
   * @param xy entry of its covariance
   * @param yy entry of its covariance
   * @return the least normalised innovation squared, NaN if it cannot be compared
   */
  public double innovate(double zX, double zY, double xx, double xy, double yy) {
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

  /**
   * How likely what {@link #innovate} has compared is.
   *
   * @return logarithm of the likelihood
   */
  public double logLikelihood() {
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
  public void correct() {
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
      double more = filter.nis() - least;
      double likelihood = more == 0 ? 1 : Math.exp(-0.5 * more);
      next[j] = probability[j] * likelihood * Math.sqrt(filter.squaredDensity());
      sum += next[j];
    }
    double kept = 0;
    for (int j = 0; j < modes; j++) {
      probability[j] = Math.max(LEAST_PROBABILITY * sum, next[j]);
      kept += probability[j];
    }
    double perKept = 1 / kept;
    for (int j = 0; j < modes; j++) {
      probability[j] *= perKept;
    }
  }

  /**
   * What all modes together had expected of what {@link #innovate} has compared.
   *
   * @return of the last comparison
   */
  public CombinedInnovation innovation() {
    return CombinedInnovation.of(filters, prior);
  }

  /**
   * The gain of the mode that is the most probable, as of the last measurement taken in.
   *
   * @param row of the state: x, y, vx, vy, rate
   * @param column of the measurement: x, y
   * @return entry of the gain
   */
  public double gain(int row, int column) {
    return likeliest().gain(row, column);
  }

  private PlaneFilter likeliest() {
    int best = 0;
    for (int j = 1; j < modes; j++) {
      best = probability[j] > probability[best] ? j : best;
    }
    return filters[best];
  }

  /**
   * Place, the mean of all modes.
   *
   * @return first coordinate
   */
  public double x() {
    combine();
    return state[0];
  }

  /**
   * Place, the mean of all modes.
   *
   * @return second coordinate
   */
  public double y() {
    combine();
    return state[1];
  }

  /**
   * Velocity, the mean of all modes.
   *
   * @return along x
   */
  public double vx() {
    combine();
    return state[2];
  }

  /**
   * Velocity, the mean of all modes.
   *
   * @return along y
   */
  public double vy() {
    combine();
    return state[3];
  }

  /**
   * How sure that is, of all modes together.
   *
   * @param row 0 to 3: x, y, vx, vy
   * @param column the same
   * @return entry of the covariance
   */
  public double covariance(int row, int column) {
    combine();
    int place = PlaneFilter.place(row, column);
    double sum = 0;
    for (int j = 0; j < modes; j++) {
      double[] x = filters[j].x;
      double apart = (x[row] - state[row]) * (x[column] - state[column]);
      sum += probability[j] * (filters[j].p[place] + apart);
    }
    return sum;
  }

  private void mixFrom(MotionModes other, double dtS) {
    mixture.goOn(dtS);
    for (int j = 0; j < modes; j++) {
      next[j] = mixture.weighTransitions(other.probability, j);
      mixture.mix(other.filters, filters[j].x, filters[j].p, noise.rateVariance(j));
    }
    System.arraycopy(next, 0, probability, 0, modes);
  }

  private void combine() {
    if (combined) {
      return;
    }
    combined = true;
    for (int i = 0; i < 4; i++) {
      double mean = 0;
      for (int j = 0; j < modes; j++) {
        mean += probability[j] * filters[j].x[i];
      }
      state[i] = mean;
    }
  }
}
