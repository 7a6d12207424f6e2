package haltere.filters.estimation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;

/**
 * Several models of one target at once, such as straight ahead and turning: each has its filter,
 * the measurements say how probable each is, and before each prediction the filters mix what they
 * know.
 *
 * <p>Blom and Bar-Shalom (1988), "The interacting multiple model algorithm for systems with
 * Markovian switching coefficients"; Bar-Shalom, Li and Kirubarajan (2001), section 11.6.6: mixing
 * eq. 11.6.6-7 to -10, mode probabilities -14, combination -16 and -17. What differs: probabilities
 * are held as logarithms, so that no likelihood, however small, loses a mode for ever; and a
 * measurement is taken in if any mode's gate lets it through, by all modes or by none.
 *
 * <p>All models have one state, of the same size, meaning and units. Thread rule: not safe for use
 * by two threads at a time.
 */
public final class InteractingMultipleModels implements Estimator {
  private final ModeSwitching switching;
  private final GapPolicy gap;
  private final InnovationMonitor monitor;
  private final List<KalmanFilter> filters = new ArrayList<>();
  private final GaussianState[] beliefs;
  private final GaussianState[] starts;
  private final GaussianState combined;
  private final double[] logProbability;
  private final double[] logNext;
  private final double[] weights;
  private final DMatrixRMaj launchState;
  private final DMatrixRMaj launchCovariance;
  private final int n;
  private double timeS;
  private double gapS;
  private long relaunches;
  private double logLikelihood = Double.NaN;

  /**
   * Modes that are all equally probable at first.
   *
   * @param models one per mode, two or more, of one state size
   * @param switching how the target changes between them
   * @param x state to launch from
   * @param p its covariance, positive definite
   * @param options gap policy, loss of lock
   */
  public InteractingMultipleModels(
      List<? extends ProcessModel> models,
      ModeSwitching switching,
      DMatrixRMaj x,
      DMatrixRMaj p,
      FilterOptions options) {
    this.switching = switching;
    int modes = Require.atLeast("models", 2, models.size());
    if (switching.modes() != modes) {
      throw new IllegalArgumentException(
          "switching is of " + switching.modes() + " modes, models are " + modes);
    }
    n = models.get(0).stateSize();
    gap = options.gap();
    monitor = new InnovationMonitor(options.lossAfter());
    beliefs = new GaussianState[modes];
    starts = new GaussianState[modes];
    for (int j = 0; j < modes; j++) {
      if (models.get(j).stateSize() != n) {
        throw new IllegalArgumentException(
            "models have states of " + n + " and " + models.get(j).stateSize() + " entries");
      }
      filters.add(new KalmanFilter(models.get(j), x, p, options.withGap(GapPolicy.UNLIMITED)));
      beliefs[j] = filters.get(j).belief();
      starts[j] = new GaussianState(n);
    }
    logProbability = new double[modes];
    Arrays.fill(logProbability, -Math.log(modes));
    logNext = new double[modes];
    weights = new double[modes];
    combined = new GaussianState(n);
    launchState = x.copy();
    launchCovariance = p.copy();
    combine();
  }

  @Override
  public int stateSize() {
    return n;
  }

  @Override
  public void launch(DMatrixRMaj state, DMatrixRMaj covariance) {
    for (KalmanFilter filter : filters) {
      filter.launch(state, covariance);
    }
    launchState.setTo(state);
    launchCovariance.setTo(covariance);
    Arrays.fill(logProbability, -Math.log(logProbability.length));
    gapS = 0;
    monitor.endRun();
    combine();
  }

  @Override
  public void predict(double dtS) {
    Require.timeStep(dtS);
    timeS += dtS;
    if (gap.relaunches(gapS, dtS)) {
      relaunches++;
      launch(launchState.copy(), launchCovariance.copy());
      return;
    }
    double stepS = gap.predicted(gapS, dtS);
    gapS += dtS;
    if (stepS > 0) {
      mix(switching.probabilities(stepS));
      for (KalmanFilter filter : filters) {
        filter.predict(stepS);
      }
      combine();
    }
  }

  @Override
  public UpdateOutcome update(MeasurementModel model, DMatrixRMaj z) {
    double least = Double.POSITIVE_INFINITY;
    for (KalmanFilter filter : filters) {
      if (!filter.innovate(model, z)) {
        return monitor.noteUnusable();
      }
      least = Math.min(least, filter.nis());
    }
    boolean passes = model.gate().passes(least, model.size());
    for (int j = 0; j < filters.size(); j++) {
      KalmanFilter filter = filters.get(j);
      logNext[j] = logProbability[j] + filter.logLikelihood();
      if (passes) {
        filter.correct();
      } else {
        filter.refuse();
      }
    }
    logLikelihood = logSum(logNext);
    if (!passes) {
      return monitor.noteGated();
    }
    for (int j = 0; j < logNext.length; j++) {
      logProbability[j] = logNext[j] - logLikelihood;
    }
    combine();
    gapS = 0;
    return monitor.noteApplied();
  }

  /**
   * How probable it is that the target is in a mode.
   *
   * @param mode from 0, in the order of the models
   * @return 0 to 1; all modes add up to 1
   */
  public double modeProbability(int mode) {
    return Math.exp(logProbability[mode]);
  }

  /**
   * The filter of one mode, to read its estimate, or to observe it. Its steps contain a launch at
   * each mixing.
   *
   * @param mode from 0, in the order of the models
   * @return the filter; do not predict, update or launch it
   */
  public KalmanFilter mode(int mode) {
    return filters.get(mode);
  }

  /**
   * Logarithm of the likelihood of the last update's measurement, over all modes.
   *
   * @return NaN before the first update
   */
  public double logLikelihood() {
    return logLikelihood;
  }

  @Override
  public double state(int index) {
    return combined.mean(index);
  }

  @Override
  public double covariance(int row, int column) {
    return combined.covariance(row, column);
  }

  @Override
  public Estimate estimate() {
    return new Estimate(
        timeS, ConstMatrix.copyOf(combined.mean()), ConstMatrix.copyOf(combined.covariance()));
  }

  @Override
  public InnovationMonitor monitor() {
    return monitor;
  }

  @Override
  public long relaunches() {
    return relaunches;
  }

  /**
   * Gives each filter the mixture of all that it would start from if the target were in its mode.
   */
  private void mix(DMatrixRMaj transition) {
    int modes = beliefs.length;
    for (int j = 0; j < modes; j++) {
      for (int i = 0; i < modes; i++) {
        weights[i] = Math.log(transition.get(i, j)) + logProbability[i];
      }
      logNext[j] = logSum(weights);
      if (logNext[j] == Double.NEGATIVE_INFINITY) {
        // a mode that cannot be reached keeps its own estimate
        starts[j].set(beliefs[j]);
      } else {
        mix(starts[j], logNext[j]);
      }
    }
    for (int j = 0; j < modes; j++) {
      filters.get(j).set(starts[j].mean(), starts[j].covariance());
      logProbability[j] = logNext[j];
    }
  }

  private void combine() {
    System.arraycopy(logProbability, 0, weights, 0, weights.length);
    mix(combined, 0);
  }

  /** Mixes the filters' beliefs by {@link #weights}, which are logarithms. */
  private void mix(GaussianState into, double logTotal) {
    for (int i = 0; i < weights.length; i++) {
      weights[i] = Math.exp(weights[i] - logTotal);
    }
    into.mix(beliefs, weights);
  }

  private static double logSum(double[] logs) {
    double greatest = Double.NEGATIVE_INFINITY;
    for (double log : logs) {
      greatest = Math.max(greatest, log);
    }
    if (greatest == Double.NEGATIVE_INFINITY) {
      return greatest;
    }
    double sum = 0;
    for (double log : logs) {
      sum += Math.exp(log - greatest);
    }
    return greatest + Math.log(sum);
  }
}
