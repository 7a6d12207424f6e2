package haltere.filters.orientation.internal.axis;

/**
 * The error-state form: a few {@link AxisHypothesis hypotheses} of the axis on the unit sphere,
 * each with its probability.
 *
 * <p>A line is the body's with probability 1 − ε and an outlier with ε. An ambiguous line splits a
 * hypothesis in two, and later lines decide between them (Reid 1979). One outlier of two lines thus
 * makes the axis uncertain, not wrong. The rates have two noises, of calm flight and of saccades;
 * each hypothesis is continued with both (Markov chain). Similar hypotheses are merged, unlikely
 * ones dropped.
 *
 * <p>With some probability no hypothesis is true and the axis may be any. It grows when all lines
 * contradict; an axis that is then found anew competes with the others ({@link #offer}).
 *
 * <p>The estimate is the mean of the hypotheses with their second moment, that of an unknown axis
 * included.
 */
public final class SphereFilter implements AxisFilter {
  /** Logarithm of the odds to the best hypothesis beyond which one is dropped. */
  private static final double MAX_LOG_ODDS = Math.log(1e5);

  /** Probability of an inlier, or of an outlier, below which a hypothesis is not split. */
  private static final double MIN_AMBIGUITY = 0.02;

  /** Rate of losses of the axis that the model does not explain, per second. */
  private static final double LOSSES_PER_S = 0.01;

  /** Probability that no hypothesis is true above which the axis is searched again. */
  private static final double SEARCH_THRESHOLD = 1e-4;

  /** Probability of the best hypothesis above which the axis is unambiguous. */
  private static final double SETTLED = 0.9;

  /** Variance of an expected line at which the gate is √2 times as wide. */
  private static final double GATE_VARIANCE = Math.toRadians(15) * Math.toRadians(15);

  /** Variance of the axis above which a hypothesis may have exchanged head and tail. */
  private static final double AMBIGUOUS_VARIANCE = Math.toRadians(15) * Math.toRadians(15);

  /** Variance of a random axis in each of two directions. */
  private static final double UNKNOWN_VARIANCE = (Math.PI - 2) / 2;

  final double[] rateVariances;
  private final AxisModel model;
  private final double gateRad;
  private final double outliers;
  private final double logOutlier;
  private final double logInlier;
  final RateDecay decay;
  final HypothesisSet hypotheses = new HypothesisSet();
  final AxisMixture mixture = new AxisMixture(hypotheses, UNKNOWN_VARIANCE);
  private LineComparison seen = new LineComparison();
  private LineComparison closest = new LineComparison();

  private double begins;
  private double ends;
  private boolean hasStepped;

  /** Probability that no hypothesis is true. */
  private double unknown;

  private boolean recording;

  /**
   * A filter without an axis.
   *
   * @param model of the axis and its lines
   */
  public SphereFilter(AxisModel model) {
    this.model = model;
    double calm = model.calmRateRadS();
    double saccade = model.saccadeRateRadS();
    rateVariances =
        calm == saccade
            ? new double[] {calm * calm}
            : new double[] {calm * calm, saccade * saccade};
    decay = new RateDecay(model.decayS());
    gateRad = model.gateRad();
    outliers = model.outlierShare();
    logOutlier = outliers == 0 ? Double.NEGATIVE_INFINITY : Math.log(outliers / Math.PI);
    logInlier = Math.log(1 - outliers);
  }

  @Override
  public void launch(AxisLaunch found) {
    launch(found.axis(), found.covariance());
    double rest = unexplained();
    unknown = rest / (rest + found.odds());
    mixture.changed(unknown);
  }

  /** Starts with an axis that is certain but for its covariance. */
  void launch(double[] axis, double[] covariance) {
    hypotheses.clear();
    start(hypotheses.add(), axis, covariance).logWeight = 0;
    hypotheses.settle(0);
    unknown = 0;
    hasStepped = false;
    mixture.changed(unknown);
  }

  private AxisHypothesis start(AxisHypothesis hypothesis, double[] axis, double[] covariance) {
    hypothesis.launch(axis, covariance, model.meanRateVariance());
    hypothesis.saccadeShare = model.saccadeShare();
    hypothesis.expect(0);
    if (recording) {
      hypothesis.step = new AxisStep(null, null, hypothesis.state(), null);
    }
    return hypothesis;
  }

  /** Probability that at least one of two lines is an outlier. */
  private double unexplained() {
    return 1 - (1 - outliers) * (1 - outliers);
  }

  @Override
  public void predict(double dtS) {
    hasStepped = dtS > 0;
    decay.step(dtS);
    begins = -Math.expm1(-model.saccadesPerS() * dtS);
    ends = -Math.expm1(-dtS / model.saccadeS());
    for (int i = 0; i < hypotheses.size(); i++) {
      hypotheses.get(i).predict(decay);
    }
    if (outliers > 0) {
      double lost = -Math.expm1(-LOSSES_PER_S * dtS);
      unknown += (1 - unknown) * lost;
    }
    mixture.changed(unknown);
  }

  @Override
  public void update(LineMeasurement[] lines, int count) {
    if (count == 0 && !hasStepped && !recording) {
      return;
    }
    double[] expected = mixture.mean().u;
    for (int i = 0; i < count; i++) {
      lines[i].residualRad = lines[i].residual(expected);
    }
    int known = hypotheses.advance();
    for (int i = 0; i < known; i++) {
      continueWith(hypotheses.old(i), lines, count);
    }
    for (int i = 0; i < hypotheses.size(); i++) {
      decide(hypotheses.get(i), lines, count);
    }
    double none = unknown * Math.pow(Math.PI, -count);
    unknown = hypotheses.settle(none);
    hypotheses.split();
    if (recording) {
      hypotheses.record();
    }
    mixture.changed(unknown);
    report(lines, count);
    hasStepped = false;
  }

  /** Continues a hypothesis in calm flight and in a saccade. */
  private void continueWith(AxisHypothesis hypothesis, LineMeasurement[] lines, int count) {
    double saccade = nextSaccadeShare(hypothesis);
    int modes = hasStepped ? rateVariances.length : 1;
    for (int mode = 0; mode < modes; mode++) {
      double share = modes == 1 ? 1 : mode == 0 ? 1 - saccade : saccade;
      AxisHypothesis next = hypotheses.add();
      if (next == null) {
        return;
      }
      next.copy(hypothesis);
      next.logWeight = Math.log(hypothesis.weight * (1 - unknown) * share);
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
          reject(next, i);
        }
      }
    }
  }

  /** Probability that the body is in a saccade after the step. */
  double nextSaccadeShare(AxisHypothesis hypothesis) {
    return hypothesis.saccadeShare * (1 - ends) + (1 - hypothesis.saccadeShare) * begins;
  }

  /** Whether a line is in the gate, which is wider where the expected line is uncertain. */
  private boolean isInGate(AxisHypothesis hypothesis, LineMeasurement line) {
    double off = Math.abs(line.residual(hypothesis.u));
    return off < gateRad
        || (seen.compare(hypothesis, line)
            && off < gateRad * Math.sqrt(1 + seen.expectedVariance() / GATE_VARIANCE));
  }

  private void reject(AxisHypothesis hypothesis, int line) {
    hypothesis.decided[line] = true;
    hypothesis.undecided--;
    hypothesis.logWeight += Math.max(-20, logOutlier);
  }

  /** Assigns the lines one after the other, by increasing innovation. */
  private void decide(AxisHypothesis hypothesis, LineMeasurement[] lines, int count) {
    while (hypothesis.undecided > 0) {
      if (hypothesis.logWeight < hypotheses.best - MAX_LOG_ODDS) {
        hypothesis.logWeight = Double.NEGATIVE_INFINITY;
        return;
      }
      int nearest = nearest(hypothesis, lines, count);
      if (nearest < 0) {
        for (int i = 0; i < count; i++) {
          if (!hypothesis.decided[i]) {
            reject(hypothesis, i);
          }
        }
        break;
      }
      LineComparison seen = closest;
      double log = logInlier - 0.5 * (seen.nis() + Math.log(2 * Math.PI * seen.variance()));
      double inlier = outliers == 0 ? 1 : 1 / (1 + Math.exp(logOutlier - log));
      if (inlier < MIN_AMBIGUITY) {
        reject(hypothesis, nearest);
        continue;
      }
      AxisHypothesis without = inlier < 1 - MIN_AMBIGUITY ? hypotheses.add() : null;
      if (without != null) {
        without.copy(hypothesis);
        reject(without, nearest);
      }
      hypothesis.accept(nearest, seen);
      hypothesis.logWeight += log;
    }
    hypothesis.recentre(true);
    hypotheses.best = Math.max(hypotheses.best, hypothesis.logWeight);
  }

  /** The undecided line with the smallest innovation, which {@link #closest} then holds. */
  private int nearest(AxisHypothesis hypothesis, LineMeasurement[] lines, int count) {
    int nearest = -1;
    for (int i = 0; i < count; i++) {
      if (!hypothesis.decided[i]
          && seen.compare(hypothesis, lines[i])
          && (nearest < 0 || seen.nis() < closest.nis())) {
        LineComparison other = closest;
        closest = seen;
        seen = other;
        nearest = i;
      }
    }
    return nearest;
  }

  /** Sets the results of the lines by the best hypothesis. */
  private void report(LineMeasurement[] lines, int count) {
    AxisHypothesis best = hypotheses.get(0);
    for (int i = 0; i < count; i++) {
      lines[i].used = !Double.isNaN(best.nis[i]);
      lines[i].nis = best.nis[i];
      lines[i].ownRad2 = best.own[i];
    }
  }

  @Override
  public void coupleToFlight(double[] direction, double variance, double fresh) {
    hypotheses.coupleToFlight(
        direction, variance, fresh, mixture.axisVariance() > AMBIGUOUS_VARIANCE);
    mixture.changed(unknown);
  }

  @Override
  public boolean needsSearch(LineMeasurement[] lines, int count) {
    return unknown > SEARCH_THRESHOLD;
  }

  @Override
  public boolean offer(AxisLaunch found) {
    AxisHypothesis hypothesis = hypotheses.addLasting();
    if (hypothesis == null) {
      return false;
    }
    start(hypothesis, found.axis(), found.covariance());
    double chance = unknown * found.odds();
    double rest = unknown * unexplained();
    unknown = hypotheses.include(hypothesis, chance, rest, 1 - unknown);
    mixture.changed(unknown);
    return hypotheses.get(0) == hypothesis;
  }

  /** Roll is unknown: no camera sees the rotation about the axis. */
  @Override
  public Axis axis() {
    AxisState mean = mixture.mean().state();
    return new Axis(
        mean.u(),
        mean.tipVelocity(),
        mixture.axisVariance(),
        mixture.agreement() * (1 - unknown) + 0.5 * unknown,
        hypotheses.get(0).weight * (1 - unknown) > SETTLED,
        Math.PI / Math.sqrt(3),
        0);
  }

  @Override
  public boolean isValid() {
    return hypotheses.size() > 0 && hypotheses.get(0).isValid();
  }

  @Override
  public void record() {
    recording = true;
  }

  @Override
  public AxisStep step() {
    return hypotheses.get(0).step;
  }
}
