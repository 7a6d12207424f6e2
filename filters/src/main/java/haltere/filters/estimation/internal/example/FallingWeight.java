package haltere.filters.estimation.internal.example;

import haltere.filters.estimation.BatchLeastSquares;
import haltere.filters.estimation.Estimate;
import haltere.filters.estimation.FilterStep;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.LinearMeasurement;
import haltere.filters.estimation.RtsSmoother;
import haltere.filters.estimation.motion.AxisMotion;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Displacement, velocity and acceleration of a falling weight: a Kalman filter on the state (s, v,
 * a), compared with a smoother, a least-squares parabola and finite differences. Start as in Casper
 * (2012): v = 0 ± 5 m/s, a = 2 ± 10 m/s²; s within 1 m of the first measurement. Immutable.
 */
public final class FallingWeight {
  /**
   * Spectral density of the jerk, m²/s⁵: in 0.4 s the acceleration may change by 0.006 m/s². The
   * drag of the air on a weight of 1 kg and 10 cm² changes it by 0.01 m/s² at 4 m/s.
   */
  private static final double JERK_DENSITY = 1e-4;

  /** Prior variance of a parabola's parameters: unknown. */
  private static final double UNKNOWN = 1e12;

  private final MeasurementSeries series;
  private final List<Estimate> estimates = new ArrayList<>();
  private final List<Estimate> smoothed;
  private final Estimate parabola;

  /**
   * Estimates.
   *
   * @param series measurements of the fall
   */
  public FallingWeight(MeasurementSeries series) {
    this.series = series;
    KalmanFilter filter =
        new KalmanFilter(
            AxisMotion.whiteJerk(1, JERK_DENSITY),
            new DMatrixRMaj(3, 1, true, series.get(0).xM(), 0, 2),
            CommonOps_DDRM.diag(1, 25, 100));
    List<FilterStep> steps = new ArrayList<>();
    filter.observe(steps::add);
    DMatrixRMaj r = series.noise();
    DMatrixRMaj h = new DMatrixRMaj(r.numRows, 3);
    for (int i = 0; i < r.numRows; i++) {
      h.set(i, 2 * i, 1); // s, then a
    }
    LinearMeasurement model = new LinearMeasurement(h, r, Gate.OPEN);
    BatchLeastSquares fit =
        new BatchLeastSquares(
            AxisMotion.constantAcceleration(1, 0),
            LinearMeasurement.ofEntries(3, r.get(0, 0), 0),
            new DMatrixRMaj(3, 1),
            CommonOps_DDRM.diag(UNKNOWN, UNKNOWN, UNKNOWN));
    for (int k = 0; k < series.size(); k++) {
      filter.predict(series.dtS(k));
      filter.update(model, series.z(k));
      estimates.add(filter.estimate());
      fit.add(series.dtS(k), series.get(k).xM());
    }
    smoothed = RtsSmoother.smooth(steps);
    parabola =
        fit.fit(new DMatrixRMaj(3, 1))
            .orElseThrow(() -> new ArithmeticException("no parabola fits the measurements"))
            .first();
  }

  /** (s, v, a) at each measurement, from those up to it. */
  List<Estimate> estimates() {
    return List.copyOf(estimates);
  }

  /**
   * All results, a row for each measurement.
   *
   * @return {@code s, v, a} with deviations and gains: the filter's, from the measurements up to
   *     the row's; {@code smoothed}: the smoother's, {@code fit}: the parabola's, both from all;
   *     {@code difference}: finite differences, unknown at both ends
   */
  public ExampleTable table() {
    DoubleUnaryOperator fitV = t -> parabola.value(1) + parabola.value(2) * t;
    DoubleUnaryOperator fitS =
        t -> parabola.value(0) + t * (parabola.value(1) + fitV.applyAsDouble(t)) / 2;
    double startS = series.get(0).tS();
    return new ExampleTable(series)
        .add("s_m", estimates, 0)
        .add("v_m_s", estimates, 1)
        .add("a_m_s2", estimates, 2)
        .addGain("gain_s", estimates, 0, series.noiseM())
        .addGain("gain_v_per_s", estimates, 1, series.noiseM())
        .addGain("gain_a_per_s2", estimates, 2, series.noiseM())
        .add("smoothed_a_m_s2", smoothed, 2)
        .add("fit_s_m", k -> fitS.applyAsDouble(series.get(k).tS() - startS))
        .add("fit_v_m_s", k -> fitV.applyAsDouble(series.get(k).tS() - startS))
        .add("fit_a_m_s2", Collections.nCopies(series.size(), parabola), 2);
  }
}
