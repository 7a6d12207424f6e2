package haltere.filters.estimation.internal.example;

import static haltere.filters.estimation.motion.DampedOscillator.DAMPING;
import static haltere.filters.estimation.motion.DampedOscillator.FREQUENCY;
import static haltere.filters.estimation.motion.DampedOscillator.POSITION;
import static haltere.filters.estimation.motion.DampedOscillator.VELOCITY;

import haltere.filters.estimation.BatchLeastSquares;
import haltere.filters.estimation.BatchLeastSquares.Solution;
import haltere.filters.estimation.Estimate;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.MeasurementModel;
import haltere.filters.estimation.motion.DampedOscillator;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.mult.VectorVectorMult_DDRM;

/**
 * Damping and frequency of a weight on a spring: state (s, v, ζ, ω) of {@link DampedOscillator}
 * without process noise. Start as in Casper (2012): s = 0 ± 1 m, v = 0.6 ± 10 m/s, ζ = 0.1 ± 10, ω
 * = 3 rad/s with a variance of 1,000 rad²/s².
 *
 * <p>From so wide a start an extended Kalman filter diverges. It linearises the first measurements
 * at wrong v, ζ and ω, where ζ and ω seem observable, and its covariance shrinks permanently. Here
 * {@link BatchLeastSquares} over all measurements so far replaces the filter's state and covariance
 * each time their number has grown by a quarter. It begins at the trajectory found before, and also
 * at the start if the residuals of that one are not noise (χ², 95 %); the better fit is used. (ζ,
 * ω) and (−ζ, −ω) are the same motion; the one with ω ≥ 0 is returned. A state that oscillates or
 * decays faster than once between two measurements is invalid.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class Oscillator {
  static final double START_FREQUENCY_RAD_S = 3;

  /** Longest time between measurements: half an oscillation at the start's frequency (Nyquist). */
  private static final double MAX_STEP_S = Math.PI / START_FREQUENCY_RAD_S;

  private final MeasurementSeries series;
  private final MeasurementModel model;
  private final DMatrixRMaj mean;
  private final DMatrixRMaj covariance = CommonOps_DDRM.diag(1, 100, 100, 1000);
  private final DampedOscillator motion;
  private final List<Estimate> estimates = new ArrayList<>();
  private Optional<Solution> solution = Optional.empty();

  /** Displacement, or displacement and acceleration, with the covariance R. */
  private record Measured(DMatrixRMaj r) implements MeasurementModel {
    @Override
    public int size() {
      return r.numRows;
    }

    @Override
    public void expected(DMatrixRMaj x, DMatrixRMaj z) {
      z.set(0, 0, x.get(POSITION));
      if (size() > 1) {
        z.set(1, 0, DampedOscillator.acceleration(x.data));
      }
    }

    @Override
    public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
      h.zero();
      h.set(0, POSITION, 1);
      if (size() > 1) {
        DMatrixRMaj slope = new DMatrixRMaj(1, 4);
        DampedOscillator.accelerationSlope(x.data, slope.data);
        CommonOps_DDRM.insert(slope, h, 1, 0);
      }
    }

    @Override
    public void noise(DMatrixRMaj x, DMatrixRMaj noise) {
      noise.setTo(r);
    }
  }

  /**
   * For measurements.
   *
   * @param series displacements from rest
   * @throws IllegalArgumentException if two are more than a second apart
   */
  public Oscillator(MeasurementSeries series) {
    this(series, START_FREQUENCY_RAD_S);
  }

  Oscillator(MeasurementSeries series, double startFrequencyRadS) {
    this.series = series;
    model = new Measured(series.noise());
    double meanStepS = (series.get(series.size() - 1).tS() - series.get(0).tS()) / series.size();
    motion = new DampedOscillator(2 * Math.PI / meanStepS);
    mean = new DMatrixRMaj(4, 1, true, 0, 0.6, 0.1, startFrequencyRadS);
    for (int k = 0; k < series.size(); k++) {
      if (series.dtS(k) > MAX_STEP_S) {
        throw new IllegalArgumentException(
            "there are no measurements for "
                + (float) series.dtS(k)
                + " s before t_s = "
                + series.get(k).tS()
                + "; an oscillation needs one per second");
      }
    }
  }

  private void estimate() {
    BatchLeastSquares batch = new BatchLeastSquares(motion, model, mean, covariance);
    KalmanFilter filter = filter();
    int window = motion.stateSize();
    for (int k = 0; k < series.size(); k++) {
      batch.add(series.dtS(k), series.z(k));
      advance(filter, model, k);
      boolean isSearched = k + 1 == window || k + 1 == series.size();
      if (isSearched) {
        solution = better(batch, (k + 1) * model.size());
        solution.ifPresent(found -> launch(filter, found.last()));
        window = k + 1 + Math.max(1, k / 4);
      }
      estimates.add(isSearched && solution.isPresent() ? solution.get().last() : filter.estimate());
    }
  }

  /** Updates with a measurement; false if the filter has diverged, until it is launched. */
  private boolean advance(KalmanFilter filter, MeasurementModel measured, int k) {
    try {
      filter.predict(series.dtS(k));
      filter.update(measured, series.z(k));
      return true;
    } catch (ArithmeticException diverged) {
      return false;
    }
  }

  private KalmanFilter filter() {
    return new KalmanFilter(motion, mean, covariance);
  }

  private static void launch(KalmanFilter filter, Estimate found) {
    DMatrixRMaj p = found.covariance().toMatrix();
    // the covariance of an unbounded trajectory may be singular to rounding, or overflow
    if (!MatrixFeatures_DDRM.hasUncountable(p) && MatrixFeatures_DDRM.isPositiveDefinite(p)) {
      filter.launch(found.state().toMatrix(), p);
    }
  }

  private Optional<Solution> better(BatchLeastSquares batch, int numbers) {
    Optional<Solution> next =
        solution.flatMap(before -> fit(batch, before.first().state().toMatrix()));
    double upper = Gate.probability(0.975).threshold(numbers);
    if (next.isPresent() && next.get().cost() <= upper) {
      return next;
    }
    return Stream.concat(next.stream(), fit(batch, mean).stream())
        .min(Comparator.comparingDouble(Solution::cost));
  }

  private static Optional<Solution> fit(BatchLeastSquares batch, DMatrixRMaj start) {
    Optional<Solution> found = batch.fit(start);
    if (found.isEmpty() || found.get().first().value(FREQUENCY) >= 0) {
      return found;
    }
    DMatrixRMaj mirrored = found.get().first().state().toMatrix();
    mirrored.set(DAMPING, 0, -mirrored.get(DAMPING));
    mirrored.set(FREQUENCY, 0, -mirrored.get(FREQUENCY));
    return batch.fit(mirrored);
  }

  /** (s, v, ζ, ω) at each measurement, from those up to it; computed at the first call. */
  List<Estimate> estimates() {
    if (estimates.isEmpty()) {
      estimate();
    }
    return List.copyOf(estimates);
  }

  /**
   * The extended Kalman filter of Casper (2012), which linearises each measurement once: (s, v, ζ,
   * ω) at each measurement, up to the first state that is not finite.
   */
  List<Estimate> plainFilter(double noiseM) {
    DMatrixRMaj r = series.noise();
    r.set(0, 0, noiseM * noiseM);
    KalmanFilter filter = filter();
    List<Estimate> all = new ArrayList<>();
    for (int k = 0; k < series.size() && advance(filter, new Measured(r), k); k++) {
      all.add(filter.estimate());
    }
    return all;
  }

  /**
   * All results, a row for each measurement.
   *
   * @return {@code s, v, a, damping, frequency} with deviations and gains: from the measurements up
   *     to the row's, unknown where the filter has diverged; {@code fit}: the trajectory that fits
   *     all measurements, unknown if none does; {@code difference}: finite differences, unknown at
   *     both ends; {@code plain}: the filter that linearises once, unknown once it diverged
   */
  public ExampleTable table() {
    double noise = series.noiseM();
    List<Estimate> estimates = estimates();
    List<Estimate> plain = plainFilter(noise);
    List<DMatrixRMaj> fit = new ArrayList<>();
    fit.add(
        solution
            .map(found -> found.first().state().toMatrix())
            .orElse(new DMatrixRMaj(4, 1, true, Double.NaN, Double.NaN, 0, 0)));
    for (int k = 1; k < series.size(); k++) {
      fit.add(new DMatrixRMaj(4, 1));
      motion.evolve(fit.get(k - 1), series.dtS(k), fit.get(k));
    }
    return new ExampleTable(series)
        .add("s_m", estimates, POSITION)
        .add("v_m_s", estimates, VELOCITY)
        .add("a_m_s2", k -> DampedOscillator.acceleration(estimates.get(k).state().toMatrix().data))
        .add("sd_a_m_s2", k -> accelerationDeviation(estimates.get(k)))
        .add("damping", estimates, DAMPING)
        .add("frequency_rad_s", estimates, FREQUENCY)
        .addGain("gain_s", estimates, POSITION, noise)
        .addGain("gain_v_per_s", estimates, VELOCITY, noise)
        .addGain("gain_damping_per_m", estimates, DAMPING, noise)
        .addGain("gain_frequency_rad_s_m", estimates, FREQUENCY, noise)
        .add("fit_s_m", k -> fit.get(k).get(POSITION))
        .add("fit_v_m_s", k -> fit.get(k).get(VELOCITY))
        .add("plain_damping", k -> valueOrNaN(plain, k, DAMPING))
        .add("plain_frequency_rad_s", k -> valueOrNaN(plain, k, FREQUENCY));
  }

  private static double valueOrNaN(List<Estimate> estimates, int k, int entry) {
    return k < estimates.size() ? estimates.get(k).value(entry) : Double.NaN;
  }

  private static double accelerationDeviation(Estimate estimate) {
    DMatrixRMaj slope = new DMatrixRMaj(4, 1);
    DampedOscillator.accelerationSlope(estimate.state().toMatrix().data, slope.data);
    return Math.sqrt(
        VectorVectorMult_DDRM.innerProdA(slope, estimate.covariance().toMatrix(), slope));
  }
}
