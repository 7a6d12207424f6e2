package haltere.filters.wing.tracker;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.ConstMatrix;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingAverage;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingDifference;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.WingVariances;
import haltere.filters.wing.internal.stroke.SideEstimator;
import org.ejml.data.DMatrixRMaj;

/** Reports the estimates of both wings to a listener. */
final class FlyReport {
  /**
   * Angles of a beat in a drawing; straight lines between them are within 0.2 degrees of a sine.
   */
  private static final int BEAT_STEPS = 48;

  private final WingListener listener;
  private final WingEstimators wings;
  private final long[] beatCount = new long[2];

  FlyReport(WingListener listener, WingEstimators wings) {
    this.listener = listener;
    this.wings = wings;
  }

  /** Restarts the count of beats. */
  void begin() {
    beatCount[0] = 0;
    beatCount[1] = 0;
  }

  /** Reports estimates; of both methods if the running average runs beside the Kalman filter. */
  void tick(long timeUs, boolean both) {
    WingEstimate[] now = new WingEstimate[2];
    for (int side = 0; side < 2; side++) {
      SideEstimator wing = wings.main[side];
      if (wings.tracked[side] && listener.isRequested(WingEstimate.class)) {
        for (int edge = 0; edge < 2; edge++) {
          if (wings.takesNow[2 * side + edge]) {
            listener.accept(wing.estimate(edge));
          }
        }
        now[side] = wing.estimate(SideEstimator.WING);
        listener.accept(now[side]);
        if (both) {
          beside(now[side], wings.beside[side].estimate(SideEstimator.WING));
        }
      }
      if (wings.tracked[side] && listener.isRequested(WingVariances.class)) {
        for (WingFilterState filter : wing.filters()) {
          listener.accept(WingVariances.of(timeUs, filter));
        }
      }
    }
    if (now[0] != null && now[1] != null) {
      pair(now[0], now[1]);
    }
  }

  /** Reports an event, unless it was rejected. */
  void event(long timeUs, int side, boolean on, double measuredRad, double expectedRad) {
    if (Double.isNaN(expectedRad)) {
      return;
    }
    WingEstimate e = wings.main[side].estimate(on ? SideEstimator.TRAILING : SideEstimator.LEADING);
    listener.accept(
        new WingMeasurement(
            timeUs,
            e.edge(),
            Angles.wrapTwoPi(measuredRad),
            Angles.wrapTwoPi(expectedRad),
            e.centreRad(),
            e.amplitudeRad(),
            e.phaseRad(),
            e.frequencyHz()));
  }

  private void beside(WingEstimate filter, WingEstimate average) {
    listener.accept(new WingAverage(average));
    listener.accept(
        new WingDifference(
            filter.timeUs(),
            filter.edge(),
            Angles.wrapPi(filter.angleRad() - average.angleRad()),
            filter.centreRad() - average.centreRad(),
            filter.amplitudeRad() - average.amplitudeRad(),
            Angles.wrapPi(filter.phaseRad() - average.phaseRad()),
            filter.frequencyHz() - average.frequencyHz()));
  }

  private void pair(WingEstimate left, WingEstimate right) {
    listener.accept(
        new WingPair(
            left.timeUs(),
            left.angleRad() - right.angleRad(),
            left.angleRad() + right.angleRad(),
            left.amplitudeRad() - right.amplitudeRad(),
            left.amplitudeRad() + right.amplitudeRad(),
            Angles.wrapPi(right.phaseRad() - left.phaseRad()),
            Math.hypot(left.sdAngleRad(), right.sdAngleRad())));
  }

  /** Reports a snapshot to be drawn. */
  void snapshot(long timeUs, Phase phase, FlyGeometry geometry, double regionPx) {
    DMatrixRMaj strokes = new DMatrixRMaj(4, BEAT_STEPS);
    double[] frequency = {Double.NaN, Double.NaN};
    double[] sd = {Double.NaN, Double.NaN};
    strokes.fill(Double.NaN);
    for (int side = 0; side < 2; side++) {
      if (wings.tracked[side]) {
        SideEstimator wing = wings.main[side];
        WingEstimate now = wing.estimate(SideEstimator.WING);
        frequency[side] = now.frequencyHz();
        sd[side] = now.sdAngleRad();
        double[][] beat = wing.beat(BEAT_STEPS);
        for (int edge = 2 * side; edge < 2 * side + 2; edge++) {
          if (wings.takesNow[edge]) {
            System.arraycopy(beat[edge % 2], 0, strokes.data, edge * BEAT_STEPS, BEAT_STEPS);
          }
        }
      }
    }
    listener.accept(
        new WingSnapshot(
            timeUs,
            phase,
            geometry,
            regionPx,
            ConstMatrix.copyOf(strokes),
            ConstMatrix.column(frequency),
            ConstMatrix.column(sd)));
  }

  /** Reports a beat that has ended; the first one has no start and is omitted. */
  void beat(WingPart side, double timeUs, double periodUs, double minRad, double maxRad) {
    int own = side.sideNumber();
    if (!(periodUs > 0) || !wings.locked) {
      return;
    }
    double lag =
        wings.tracked[1 - own]
            ? Angles.wrapPi(phaseAt(1 - own, timeUs) - phaseAt(own, timeUs))
            : Double.NaN;
    listener.accept(
        new WingBeat(
            side,
            ++beatCount[own],
            Math.round(timeUs),
            periodUs,
            1e6 / periodUs,
            (maxRad - minRad) / 2,
            minRad,
            maxRad,
            lag));
  }

  /** Phase of a wing at a time near the present one. */
  private double phaseAt(int side, double timeUs) {
    WingEstimate now = wings.main[side].estimate(SideEstimator.WING);
    return now.phaseRad() + 2 * Math.PI * now.frequencyHz() * (timeUs - now.timeUs()) * 1e-6;
  }
}
