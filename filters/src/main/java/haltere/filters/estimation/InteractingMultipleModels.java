package haltere.filters.estimation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

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
public final class InteractingMultipleModels implements Estimator<MeasurementModel> {
  private final ModeSwitching switching;
  private final GapPolicy gap;
  private final InnovationMonitor monitor;
  private final List<ExtendedKalmanFilter> filters = new ArrayList<>();
  private final double[] logProbability;
  private final double[] logInitial;
  private final double[] mixed;
  private final DMatrixRMaj[] mixedState;
  private final DMatrixRMaj[] mixedCovariance;
  private final DMatrixRMaj launchState;
  private final DMatrixRMaj launchCovariance;
  private final DMatrixRMaj x;
  private final DMatrixRMaj p;
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
   * @param options form, gap policy, loss of lock
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
    mixedState = new DMatrixRMaj[modes];
    mixedCovariance = new DMatrixRMaj[modes];
    for (int j = 0; j < modes; j++) {
      if (models.get(j).stateSize() != n) {
        throw new IllegalArgumentException(
            "models have states of " + n + " and " + models.get(j).stateSize() + " entries");
      }
      filters.add(
          new ExtendedKalmanFilter(models.get(j), x, p, options.withGap(GapPolicy.UNLIMITED)));
      mixedState[j] = new DMatrixRMaj(n, 1);
      mixedCovariance[j] = new DMatrixRMaj(n, n);
    }
    logInitial = new double[modes];
    Arrays.fill(logInitial, -Math.log(modes));
    logProbability = logInitial.clone();
    mixed = new double[modes];
    launchState = x.copy();
    launchCovariance = p.copy();
    this.x = x.copy();
    this.p = p.copy();
  }

  @Override
  public int stateSize() {
    return n;
  }

  @Override
  public void launch(DMatrixRMaj state, DMatrixRMaj covariance) {
    for (ExtendedKalmanFilter filter : filters) {
      filter.launch(state, covariance);
    }
    launchState.setTo(state);
    launchCovariance.setTo(covariance);
    System.arraycopy(logInitial, 0, logProbability, 0, logInitial.length);
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
      for (ExtendedKalmanFilter filter : filters) {
        filter.predict(stepS);
      }
      combine();
    }
  }

  @Override
  public UpdateOutcome update(MeasurementModel model, DMatrixRMaj z) {
    double least = Double.POSITIVE_INFINITY;
    for (ExtendedKalmanFilter filter : filters) {
      if (!filter.innovate(model, z)) {
        return monitor.noteUnusable();
      }
      least = Math.min(least, filter.nis());
    }
    boolean passes = model.gate().passes(least, model.size());
    for (int j = 0; j < filters.size(); j++) {
      ExtendedKalmanFilter filter = filters.get(j);
      mixed[j] = logProbability[j] + filter.logLikelihood();
      if (passes) {
        filter.correct();
      } else {
        filter.refuse();
      }
    }
    logLikelihood = logSum(mixed);
    if (!passes) {
      return monitor.noteGated();
    }
    for (int j = 0; j < mixed.length; j++) {
      logProbability[j] = mixed[j] - logLikelihood;
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
  public GaussianFilter<MeasurementModel> mode(int mode) {
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
    return x.get(index);
  }

  @Override
  public double covariance(int row, int column) {
    return p.get(row, column);
  }

  @Override
  public Estimate estimate() {
    return new Estimate(timeS, ConstMatrix.copyOf(x), ConstMatrix.copyOf(p));
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
    int modes = filters.size();
    double[][] logWeights = new double[modes][modes];
    double[] logNext = new double[modes];
    for (int j = 0; j < modes; j++) {
      for (int i = 0; i < modes; i++) {
        logWeights[j][i] = Math.log(transition.get(i, j)) + logProbability[i];
      }
      logNext[j] = logSum(logWeights[j]);
      if (logNext[j] == Double.NEGATIVE_INFINITY) {
        // A mode that cannot be reached keeps its own estimate.
        logWeights[j][j] = 0;
        mixture(logWeights[j], 0, mixedState[j], mixedCovariance[j]);
      } else {
        mixture(logWeights[j], logNext[j], mixedState[j], mixedCovariance[j]);
      }
    }
    for (int j = 0; j < modes; j++) {
      filters.get(j).set(mixedState[j], mixedCovariance[j]);
      logProbability[j] = logNext[j];
    }
  }

  private void combine() {
    mixture(logProbability, 0, x, p);
  }

  /** Mean and covariance of the filters' estimates, weighted. */
  private void mixture(double[] logWeights, double logTotal, DMatrixRMaj mean, DMatrixRMaj spread) {
    mean.zero();
    spread.zero();
    for (int i = 0; i < filters.size(); i++) {
      CommonOps_DDRM.addEquals(
          mean, Math.exp(logWeights[i] - logTotal), filters.get(i).stateView());
    }
    for (int i = 0; i < filters.size(); i++) {
      double weight = Math.exp(logWeights[i] - logTotal);
      DMatrixRMaj state = filters.get(i).stateView();
      DMatrixRMaj covariance = filters.get(i).covarianceView();
      for (int row = 0; row < n; row++) {
        double rowApart = state.get(row) - mean.get(row);
        for (int column = 0; column < n; column++) {
          double columnApart = state.get(column) - mean.get(column);
          spread.add(row, column, weight * (covariance.get(row, column) + rowApart * columnApart));
        }
      }
    }
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
