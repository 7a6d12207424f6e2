package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/**
 * The error-state form: a few {@link AxisHypothesis guesses} of the axis on the unit sphere, each
 * with its probability, and what they say together.
 *
 * <p>A line is the body's with probability 1 − ε and any line with ε. Where what is seen does not
 * tell which, a guess becomes two, and later lines decide between them (Reid 1979); so one false
 * line of two, which nobody can tell at the time, makes the axis uncertain and does not lead it
 * astray. The rates have two noises, of calm flight and of saccades, and each guess is continued
 * with both, as in a Markov chain. What has become alike is merged, and what has become unlikely is
 * dropped.
 *
 * <p>With some probability no guess is right: then the axis may be any. It grows when all lines
 * contradict, and an axis that is found anew then competes with the others ({@link #offer}).
 *
 * <p>The axis is the mean of the guesses and its covariance their second moment about it, that of
 * an unknown axis included.
 */
final class SphereFilter implements AxisFilter {
  /** Odds of a guess to the best one below which it is no more pursued. */
  private static final double LOG_HOPELESS = Math.log(1e5);

  /** Probability that a line is the body's, or is not, beyond which no guess becomes two. */
  private static final double CLEAR = 0.02;

  /** How often an axis is lost for no reason that the model knows, per second. */
  private static final double LOSSES_PER_S = 0.01;

  /** Probability that no guess is right, from which on an axis found anew is worth a try. */
  private static final double WORTH_A_TRY = 1e-4;

  /** Probability of the best guess at which it is the only one that matters. */
  private static final double SETTLED = 0.9;

  /** Variance of an expected line at which the gate is half as wide again. */
  private static final double VAGUE_LINE = Math.toRadians(15) * Math.toRadians(15);

  /** Variance of the axis beyond which a guess may have come round to the wrong end. */
  private static final double VAGUE_VARIANCE = Math.toRadians(15) * Math.toRadians(15);

  /** Mean of the squared angle to a random line, per direction beside the axis. */
  private static final double UNKNOWN_VARIANCE = (Math.PI - 2) / 2;

  private final double[] rateVariances;
  private final TurningSettings turning;
  private final double gateRad;
  private final double outliers;
  private final double logOutlier;
  private final double logInlier;
  private final RateDecay decay;
  private final HypothesisSet guesses = new HypothesisSet();
  private final AxisSummary summary = new AxisSummary();
  private LineComparison seen = new LineComparison();
  private LineComparison closest = new LineComparison();
  private final double[] expected = new double[3];

  private double begins;
  private double ends;
  private boolean hasStepped;

  /** Probability that no guess is right. */
  private double unknown;

  private boolean recording;
  private boolean summed;

  SphereFilter(OrientationSettings settings) {
    turning = settings.turning();
    double calm = turning.calmRateRadS();
    double wild = turning.saccadeRateRadS();
    rateVariances =
        calm == wild ? new double[] {calm * calm} : new double[] {calm * calm, wild * wild};
    decay = new RateDecay(turning.decayS());
    gateRad = Math.toRadians(settings.gate().angleDeg());
    outliers = settings.gate().effectiveOutlierShare();
    logOutlier = outliers == 0 ? Double.NEGATIVE_INFINITY : Math.log(outliers / Math.PI);
    logInlier = Math.log(1 - outliers);
  }

  @Override
  public void launch(AxisLaunch found) {
    launch(found.axis(), found.covariance());
    double rest = unexplained();
    unknown = rest / (rest + found.odds());
    changed();
  }

  /** Begins with an axis that is right for sure. */
  void launch(double[] axis, double[] covariance) {
    guesses.clear();
    begin(guesses.add(), axis, covariance).logWeight = 0;
    guesses.settle(0);
    unknown = 0;
    hasStepped = false;
    changed();
  }

  private AxisHypothesis begin(AxisHypothesis guess, double[] axis, double[] covariance) {
    guess.launch(axis, covariance, turning.meanRateVariance());
    guess.saccadeShare = turning.saccadeShare();
    guess.expect(0);
    if (recording) {
      guess.step = new AxisStep(null, null, guess.state(), null);
    }
    return guess;
  }

  /** Share of an unknown axis' lines that no axis found from two of them explains. */
  private double unexplained() {
    return 1 - (1 - outliers) * (1 - outliers);
  }

  @Override
  public void predict(double dtS) {
    hasStepped = dtS > 0;
    decay.step(dtS);
    begins = -Math.expm1(-turning.saccadesPerS() * dtS);
    ends = -Math.expm1(-dtS / turning.saccadeS());
    for (int i = 0; i < guesses.size(); i++) {
      if (hasStepped) {
        guesses.get(i).predict(decay);
      } else {
        guesses.get(i).stay();
      }
    }
    if (outliers > 0) {
      double lost = -Math.expm1(-LOSSES_PER_S * dtS);
      unknown += (1 - unknown) * lost;
    }
    changed();
  }

  @Override
  public void update(LineMeasurement[] lines, int count) {
    if (count == 0 && !hasStepped && !recording) {
      return;
    }
    summary().axis(expected);
    for (int i = 0; i < count; i++) {
      lines[i].residualRad = lines[i].residual(expected);
    }
    guesses.startAnew();
    for (int i = 0; i < guesses.oldSize(); i++) {
      continueWith(guesses.old(i), lines, count);
    }
    for (int i = 0; i < guesses.size(); i++) {
      decide(guesses.get(i), lines, count);
    }
    double none = unknown * Math.pow(Math.PI, -count);
    unknown = guesses.settle(none);
    guesses.split();
    if (recording) {
      guesses.record();
    }
    changed();
    tell(lines, count);
    hasStepped = false;
  }

  /** Continues a guess in calm flight and in a saccade. */
  private void continueWith(AxisHypothesis guess, LineMeasurement[] lines, int count) {
    double wild = guess.saccadeShare * (1 - ends) + (1 - guess.saccadeShare) * begins;
    int modes = hasStepped ? rateVariances.length : 1;
    for (int mode = 0; mode < modes; mode++) {
      double share = modes == 1 ? 1 : mode == 0 ? 1 - wild : wild;
      AxisHypothesis next = guesses.add();
      if (next == null) {
        return;
      }
      next.copy(guess);
      next.logWeight = Math.log(guess.weight * (1 - unknown) * share);
      if (modes > 1) {
        next.saccadeShare = mode;
      }
      if (hasStepped) {
        next.addNoise(decay, rateVariances[mode]);
      }
      next.expect(count);
      if (recording) {
        next.predicted = next.state();
      }
      for (int i = 0; i < count; i++) {
        if (!isInGate(next, lines[i])) {
          leaveOut(next, i);
        }
      }
    }
  }

  /** The gate is wider where the line that is expected is itself not known. */
  private boolean isInGate(AxisHypothesis guess, LineMeasurement line) {
    double off = Math.abs(line.residual(guess.u));
    return off < gateRad
        || (seen.compare(guess, line)
            && off < gateRad * Math.sqrt(1 + seen.vagueness() / VAGUE_LINE));
  }

  private void leaveOut(AxisHypothesis guess, int line) {
    guess.decided[line] = true;
    guess.undecided--;
    guess.logWeight += Math.max(-20, logOutlier);
  }

  /** Decides upon the lines one after the other, the least surprising first. */
  private void decide(AxisHypothesis guess, LineMeasurement[] lines, int count) {
    while (guess.undecided > 0) {
      if (guess.logWeight < guesses.best() - LOG_HOPELESS) {
        guesses.drop(guess);
        return;
      }
      int nearest = nearest(guess, lines, count);
      if (nearest < 0) {
        for (int i = 0; i < count; i++) {
          if (!guess.decided[i]) {
            leaveOut(guess, i);
          }
        }
        break;
      }
      LineComparison seen = closest;
      double log = logInlier - 0.5 * (seen.nis() + Math.log(2 * Math.PI * seen.variance()));
      double inlier = outliers == 0 ? 1 : 1 / (1 + Math.exp(logOutlier - log));
      if (inlier < CLEAR) {
        leaveOut(guess, nearest);
        continue;
      }
      AxisHypothesis without = inlier < 1 - CLEAR ? guesses.add() : null;
      if (without != null) {
        without.copy(guess);
        leaveOut(without, nearest);
      }
      guess.take(nearest, seen);
      guess.logWeight += log;
    }
    guess.settle();
    guesses.finish(guess);
  }

  /** The line that is least surprising; what it is beside the guess is left in {@link #closest}. */
  private int nearest(AxisHypothesis guess, LineMeasurement[] lines, int count) {
    int nearest = -1;
    for (int i = 0; i < count; i++) {
      if (!guess.decided[i]
          && seen.compare(guess, lines[i])
          && (nearest < 0 || seen.nis() < closest.nis())) {
        LineComparison other = closest;
        closest = seen;
        seen = other;
        nearest = i;
      }
    }
    return nearest;
  }

  /** Says in each line what became of it by the best guess. */
  private void tell(LineMeasurement[] lines, int count) {
    AxisHypothesis best = guesses.get(0);
    for (int i = 0; i < count; i++) {
      lines[i].used = best.used[i];
      lines[i].nis = best.nis[i];
      lines[i].ownRad2 = best.used[i] ? best.own[i] : Double.NaN;
    }
  }

  private void changed() {
    summed = false;
  }

  /** What the guesses say together, worked out when it is asked for. */
  private AxisSummary summary() {
    if (!summed) {
      summary.of(guesses, unknown, UNKNOWN_VARIANCE);
      summed = true;
    }
    return summary;
  }

  @Override
  public void lean(double[] direction, double variance, double fresh) {
    guesses.lean(direction, variance, fresh, summary().axisVariance() > VAGUE_VARIANCE);
    changed();
  }

  @Override
  public boolean doubts(LineMeasurement[] lines, int count) {
    return unknown > WORTH_A_TRY;
  }

  @Override
  public boolean offer(AxisLaunch found) {
    AxisHypothesis guess = guesses.addKept();
    if (guess == null) {
      return false;
    }
    begin(guess, found.axis(), found.covariance());
    double chance = unknown * found.odds();
    double rest = unknown * unexplained();
    unknown = guesses.include(guess, chance, rest, 1 - unknown);
    changed();
    return guesses.get(0) == guess;
  }

  @Override
  public double agreement() {
    return summary().agreement(guesses) * (1 - unknown) + 0.5 * unknown;
  }

  @Override
  public boolean isSettled() {
    return guesses.get(0).weight * (1 - unknown) > SETTLED;
  }

  @Override
  public void axis(double[] out) {
    summary().axis(out);
  }

  @Override
  public void tipVelocity(double[] out) {
    summary().tipVelocity(out);
  }

  @Override
  public double axisVariance() {
    return summary().axisVariance();
  }

  /** That of any angle at all: the frame's own rotation about the axis means nothing. */
  @Override
  public double rollSd() {
    return Math.PI / Math.sqrt(3);
  }

  @Override
  public double rollRate() {
    return 0;
  }

  @Override
  public boolean isSound() {
    return guesses.size() > 0 && guesses.get(0).isSound();
  }

  @Override
  public void record() {
    recording = true;
  }

  @Override
  public AxisStep step() {
    return guesses.get(0).step;
  }

  @Override
  public AxisState state() {
    return summary().state();
  }

  /** How many guesses there are. */
  int hypotheses() {
    return guesses.size();
  }

  /** Sets the velocity of the best guess' tip, of which the part along the axis is left out. */
  void setTipVelocity(double[] velocity) {
    AxisHypothesis best = guesses.get(0);
    best.va = Vectors.dot(velocity, best.e1);
    best.vb = Vectors.dot(velocity, best.e2);
    changed();
  }

  /**
   * The best guess' state before the update, with the noise of both modes in it as likely as they
   * are; to be asked for between {@link #predict} and {@link #update}.
   */
  AxisState predictedState() {
    AxisHypothesis best = guesses.get(0);
    double wild = best.saccadeShare * (1 - ends) + (1 - best.saccadeShare) * begins;
    int last = rateVariances.length - 1;
    AxisHypothesis copy = new AxisHypothesis();
    copy.copy(best);
    copy.addNoise(decay, (1 - wild) * rateVariances[0] + wild * rateVariances[last]);
    return copy.state();
  }

  /** How the best guess' errors went over the last step. */
  double[] transition() {
    return guesses.get(0).transition.clone();
  }
}
