package haltere.filters.wing.tracker;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingDifference;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.WingVariances;
import haltere.filters.wing.stroke.RunningAverage;
import haltere.filters.wing.stroke.SideEstimator;

/**
 * Tells a listener what the estimators of both wings say.
 *
 * <p>Thread rule: one thread at a time.
 */
final class FlyReport {
  private final WingListener listener;
  private final SideEstimator[] main;
  private final RunningAverage[] beside;
  private final boolean[] tracked;
  private final boolean[] takes;
  private final long[] beatCount = new long[2];

  /**
   * A report.
   *
   * @param listener takes the results
   * @param main estimator of each wing, read anew each time
   * @param beside running average of each wing
   * @param tracked whether each wing is tracked
   * @param takes whether events of each edge are taken
   */
  FlyReport(
      WingListener listener,
      SideEstimator[] main,
      RunningAverage[] beside,
      boolean[] tracked,
      boolean[] takes) {
    this.listener = listener;
    this.main = main;
    this.beside = beside;
    this.tracked = tracked;
    this.takes = takes;
  }

  /** Counts beats anew. */
  void begin() {
    beatCount[0] = 0;
    beatCount[1] = 0;
  }

  /**
   * Tells everything but snapshots.
   *
   * @param both whether the running average runs beside the Kalman filter
   */
  void tick(long timeUs, boolean both) {
    if (listener.wantsEstimates()) {
      for (int side = 0; side < 2; side++) {
        if (tracked[side]) {
          wing(timeUs, side);
          if (both) {
            beside(timeUs, side);
          }
        }
      }
      if (tracked[0] && tracked[1]) {
        pair(timeUs);
      }
    }
    if (listener.wantsVariances()) {
      for (int side = 0; side < 2; side++) {
        if (tracked[side]) {
          for (WingFilterState filter : main[side].filters()) {
            listener.variances(WingVariances.of(timeUs, filter));
          }
        }
      }
    }
  }

  /** Tells of an event that an estimator has taken in. */
  void event(long timeUs, int side, boolean on, double measuredRad) {
    SideEstimator e = main[side];
    listener.measurement(
        new WingMeasurement(
            timeUs,
            WingPart.edge(side, on ? 1 : 0),
            Angles.wrapTwoPi(measuredRad),
            Angles.wrapTwoPi(e.expected()),
            e.centre(),
            e.amplitude(),
            e.phase(),
            e.frequencyHz()));
  }

  private void wing(long timeUs, int side) {
    SideEstimator e = main[side];
    double centre = e.centre();
    double amplitude = e.amplitude();
    double phase = e.phase();
    double hz = e.frequencyHz();
    double sdAngle = e.sdAngle();
    double sdHz = e.sdFrequencyHz();
    for (int edge = 0; edge < 2; edge++) {
      if (takes[2 * side + edge]) {
        listener.estimate(
            new WingEstimate(
                timeUs,
                WingPart.edge(side, edge),
                Angles.wrapTwoPi(e.edgeAngle(edge)),
                centre,
                amplitude,
                phase,
                hz,
                sdAngle,
                sdHz,
                e.events(edge)));
      }
    }
    listener.estimate(row(timeUs, side, e, sdAngle, sdHz));
  }

  private void beside(long timeUs, int side) {
    SideEstimator e = main[side];
    RunningAverage average = beside[side];
    listener.average(row(timeUs, side, average, Double.NaN, Double.NaN));
    listener.difference(
        new WingDifference(
            timeUs,
            WingPart.wing(side),
            Angles.wrapPi(e.angle() - average.angle()),
            e.centre() - average.centre(),
            e.amplitude() - average.amplitude(),
            Angles.wrapPi(e.phase() - average.phase()),
            e.frequencyHz() - average.frequencyHz()));
  }

  private static WingEstimate row(
      long timeUs, int side, SideEstimator e, double sdAngle, double sdHz) {
    return new WingEstimate(
        timeUs,
        WingPart.wing(side),
        Angles.wrapTwoPi(e.angle()),
        e.centre(),
        e.amplitude(),
        e.phase(),
        e.frequencyHz(),
        sdAngle,
        sdHz,
        e.events(0) + e.events(1));
  }

  private void pair(long timeUs) {
    double left = main[0].angle();
    double right = main[1].angle();
    listener.pair(
        new WingPair(
            timeUs,
            left - right,
            left + right,
            main[0].amplitude() - main[1].amplitude(),
            main[0].amplitude() + main[1].amplitude(),
            Angles.wrapPi(main[1].phase() - main[0].phase()),
            Math.hypot(main[0].sdAngle(), main[1].sdAngle())));
  }

  /** Tells everything at once, to be drawn. */
  void snapshot(long timeUs, Phase phase, FlyGeometry geometry, double regionPx) {
    double[] edges = new double[4];
    double[] sd = new double[2];
    for (int side = 0; side < 2; side++) {
      for (int edge = 0; edge < 2; edge++) {
        edges[2 * side + edge] = tracked[side] ? main[side].edgeAngle(edge) : Double.NaN;
      }
      sd[side] = tracked[side] ? main[side].sdAngle() : Double.NaN;
    }
    listener.snapshot(new WingSnapshot(timeUs, phase, geometry, regionPx, edges, sd));
  }

  /** Tells of a beat that has ended; the first one has no beginning and is left out. */
  void beat(WingSide side, double timeUs, double periodUs, double leastRad, double mostRad) {
    int own = side.ordinal();
    if (!(periodUs > 0)) {
      return;
    }
    int other = 1 - own;
    double lag =
        tracked[other]
            ? Angles.wrapPi(main[other].phaseAt(timeUs) - main[own].phaseAt(timeUs))
            : Double.NaN;
    listener.beat(
        new WingBeat(
            side,
            ++beatCount[own],
            Math.round(timeUs),
            periodUs,
            1e6 / periodUs,
            (mostRad - leastRad) / 2,
            leastRad,
            mostRad,
            lag));
  }
}
