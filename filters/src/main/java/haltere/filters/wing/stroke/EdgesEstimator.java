package haltere.filters.wing.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.GaussianState;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingModel;
import haltere.filters.wing.WingNoiseSettings;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingTrackerSettings;
import java.util.List;

/**
 * A filter for each edge of a wing, as the source has it: h = a + M sin xi. Process noise is a
 * density, or, as in the source, the same whenever time has passed, whatever the time. Several
 * events may be averaged before an update.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class EdgesEstimator implements SideEstimator {
  private static final double US = 1e-6;
  private static final int LOST_AFTER = 400;
  private static final double START_AMPLITUDE = 1;
  private static final double START_VARIANCE = 1;

  /** What the source says that phase and frequency have in common, as near to 1 as can be. */
  private static final double START_COVARIANCE = 1 - 1e-9;

  /** Share of the noise in manoeuvres that a filter has which does not notice them. */
  private static final double MANOEUVRE_SHARE = 0.05;

  private static final double WIDEST_GATE_SD = 30;
  private static final double USUAL_MEASUREMENT = 0.006;
  private static final List<String> NAMES =
      List.of("centre", "amplitude", "phase", "angular frequency");
  private static final List<String> UNITS = List.of("rad", "rad", "rad", "rad/s");

  private final WingSide side;
  private final StrokeFrame frame;
  private final BeatListener beats;
  private final EdgeFilter[] filters = new EdgeFilter[2];

  /** Process noise of the variances, and the variance of a measurement, of each edge. */
  private final double[][] processNoise = new double[2][4];

  private final double[] measurementNoise = new double[2];
  private double expected;
  private WingNoiseSettings noise;
  private WingFilterSettings options;
  private final long[] lastUs = new long[2];
  private final long[] taken = new long[2];
  private final double[] sums = new double[2];

  /** Times of the events that are averaged, since the filter's own. */
  private final long[] ages = new long[2];

  private final int[] counts = new int[2];
  private final double[] lastPhase = new double[2];
  private long nowUs;
  private long lastEventUs;
  private double lastPassedUs = Double.NaN;

  /**
   * An estimator that has to be {@link #launch launched}.
   *
   * @param side which wing
   * @param frame where it is hinged
   * @param settings of the tracker
   * @param beats takes the beats
   */
  public EdgesEstimator(
      WingSide side, StrokeFrame frame, WingTrackerSettings settings, BeatListener beats) {
    this.side = side;
    this.frame = frame;
    this.beats = beats;
    apply(settings);
    for (int edge = 0; edge < 2; edge++) {
      filters[edge] = new EdgeFilter(gate(options.gateSd()), LOST_AFTER);
    }
  }

  private static Gate gate(double sd) {
    return sd > WIDEST_GATE_SD ? Gate.OPEN : Gate.sigmas(sd);
  }

  @Override
  public final void apply(WingTrackerSettings settings) {
    options = settings.filter();
    if (!settings.noise().equals(noise)) {
      noise = settings.noise();
      for (int edge = 0; edge < 2; edge++) {
        processNoise[edge][0] = noise.centre();
        processNoise[edge][1] = noise.amplitude();
        processNoise[edge][2] = noise.phase();
        processNoise[edge][3] =
            noise.frequency() + (isByUpdate() ? 0 : MANOEUVRE_SHARE * noise.manoeuvre());
        measurementNoise[edge] = noise.measurement();
      }
    }
  }

  private boolean isByUpdate() {
    return options.model() == WingModel.EDGES_BY_UPDATE;
  }

  /**
   * Begins with a stroke, or, as the source does, with its centre and frequency alone: amplitude 1,
   * phase the centre.
   *
   * @param atUs when, microseconds
   * @param seed the stroke
   * @param knowsPhase whether amplitude and phase of the stroke are known
   */
  public void launch(long atUs, StrokeSeed seed, boolean knowsPhase) {
    nowUs = atUs;
    lastEventUs = atUs;
    lastPassedUs = Double.NaN;
    for (int edge = 0; edge < 2; edge++) {
      sums[edge] = 0;
      ages[edge] = 0;
      counts[edge] = 0;
      taken[edge] = 0;
      double phase =
          knowsPhase ? seed.phase() + seed.omega() * (atUs - seed.timeUs()) * US : seed.centre();
      double amplitude = knowsPhase ? seed.amplitude() : START_AMPLITUDE;
      GaussianState belief = filters[edge].belief;
      belief.setMean(EdgeFilter.CENTRE, seed.centre());
      belief.setMean(EdgeFilter.AMPLITUDE, amplitude);
      belief.setMean(EdgeFilter.PHASE, Angles.wrapPi(phase));
      belief.setMean(EdgeFilter.OMEGA, seed.omega());
      belief.setVariances(START_VARIANCE, 1e-9, START_VARIANCE, START_VARIANCE);
      if (!knowsPhase) {
        belief.addNoise(EdgeFilter.PHASE, EdgeFilter.OMEGA, START_COVARIANCE);
      }
      filters[edge].monitor.endRun();
      lastUs[edge] = atUs;
      lastPhase[edge] = phase(edge);
    }
  }

  @Override
  public boolean event(long timeUs, boolean on) {
    int edge = on ? 1 : 0;
    lastEventUs = timeUs;
    taken[edge]++;
    double measured =
        counts[edge] == 0
            ? frame.angle()
            : sums[edge] / counts[edge] + Angles.wrapPi(frame.angle() - sums[edge] / counts[edge]);
    sums[edge] += measured;
    ages[edge] += timeUs - lastUs[edge];
    if (++counts[edge] < options.averagedEvents()) {
      return true;
    }
    double angle = sums[edge] / counts[edge];
    // the source takes the average for one of the last event's time, and is late by half of it
    long atUs = isByUpdate() ? timeUs : lastUs[edge] + ages[edge] / counts[edge];
    sums[edge] = 0;
    ages[edge] = 0;
    counts[edge] = 0;
    predict(edge, atUs);
    filters[edge].update(angle, measurementNoise(edge));
    expected = filters[edge].expected();
    if (edge == 0) {
      watchBeat(atUs);
    }
    return true;
  }

  private double measurementNoise(int edge) {
    return measurementNoise[edge] > 0 ? measurementNoise[edge] : USUAL_MEASUREMENT;
  }

  private void predict(int edge, long timeUs) {
    double dtS = (timeUs - lastUs[edge]) * US;
    if (dtS > 0) {
      filters[edge].predict(dtS);
      addNoise(filters[edge].belief, processNoise[edge], dtS);
      lastUs[edge] = timeUs;
    }
  }

  private void addNoise(GaussianState belief, double[] q, double dtS) {
    // the table of Cardinale (2006), in which phase and frequency have all of their noise in common
    boolean byUpdate = isByUpdate();
    double scale = byUpdate ? 1 : dtS;
    for (int i = 0; i < EdgeFilter.SIZE; i++) {
      belief.addNoise(i, q[i] * scale);
    }
    if (byUpdate) {
      belief.addNoise(EdgeFilter.PHASE, EdgeFilter.OMEGA, Math.sqrt(q[2] * q[3]));
    } else {
      belief.addNoise(EdgeFilter.PHASE, q[3] * dtS * dtS * dtS / 3);
      belief.addNoise(EdgeFilter.PHASE, EdgeFilter.OMEGA, q[3] * dtS * dtS / 2);
    }
  }

  private void watchBeat(long timeUs) {
    double phase = phase(0);
    if (phase < lastPhase[0] - Math.PI) {
      double passedUs =
          timeUs - phase / Math.max(1, filters[0].belief.mean(EdgeFilter.OMEGA)) * 1e6;
      beats.beat(
          side, passedUs, passedUs - lastPassedUs, centre() - amplitude(), centre() + amplitude());
      lastPassedUs = passedUs;
      lastPhase[0] = phase;
    } else if (phase - lastPhase[0] < Math.PI) {
      lastPhase[0] = Math.max(lastPhase[0], phase);
    }
  }

  private double phase(int edge) {
    double turns = filters[edge].belief.mean(EdgeFilter.PHASE) / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public void advance(long timeUs) {
    nowUs = timeUs;
  }

  private double turnNow(int edge) {
    return filters[edge].belief.mean(EdgeFilter.OMEGA)
        * ((nowUs - lastUs[edge]) * US + CameraLatency.seconds(options.latencyUs(), 0, 1));
  }

  @Override
  public double angle() {
    return (edgeAngle(0) + edgeAngle(1)) / 2;
  }

  @Override
  public double edgeAngle(int edge) {
    return filters[edge].angleAfter(turnNow(edge));
  }

  @Override
  public double centre() {
    return (filters[0].belief.mean(EdgeFilter.CENTRE) + filters[1].belief.mean(EdgeFilter.CENTRE))
        / 2;
  }

  @Override
  public double amplitude() {
    return (filters[0].belief.mean(EdgeFilter.AMPLITUDE)
            + filters[1].belief.mean(EdgeFilter.AMPLITUDE))
        / 2;
  }

  @Override
  public double phase() {
    double turns = (filters[0].belief.mean(EdgeFilter.PHASE) + turnNow(0)) / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public double phaseAt(double timeUs) {
    return phase() + 2 * Math.PI * frequencyHz() * (timeUs - nowUs) * US;
  }

  @Override
  public double frequencyHz() {
    return (filters[0].belief.mean(EdgeFilter.OMEGA) + filters[1].belief.mean(EdgeFilter.OMEGA))
        / (4 * Math.PI);
  }

  @Override
  public double sdAngle() {
    return filters[0].sdAngleAfter(0) / Math.sqrt(2);
  }

  @Override
  public double sdFrequencyHz() {
    return Math.sqrt(filters[0].belief.covariance(EdgeFilter.OMEGA, EdgeFilter.OMEGA) / 2)
        / (2 * Math.PI);
  }

  @Override
  public double nis() {
    return (filters[0].nis() + filters[1].nis()) / 2;
  }

  @Override
  public long events(int edge) {
    return taken[edge];
  }

  @Override
  public double expected() {
    return expected;
  }

  @Override
  public List<WingFilterState> filters() {
    return List.of(filter(0), filter(1));
  }

  private WingFilterState filter(int edge) {
    GaussianState belief = filters[edge].belief;
    return new WingFilterState(
        WingPart.edge(side.ordinal(), edge),
        NAMES,
        UNITS,
        belief.mean().data,
        belief.covariance().data,
        processNoise[edge],
        measurementNoise(edge),
        false,
        filters[edge].nis(),
        taken[edge]);
  }

  @Override
  public void edit(WingFilterEdit edit) {
    int edge = edit.part() == WingPart.edge(side.ordinal(), 0) ? 0 : 1;
    GaussianState belief = filters[edge].belief;
    switch (edit.table()) {
      case STATE ->
          belief.setMean(
              edit.row(),
              edit.row() == EdgeFilter.PHASE ? Angles.wrapPi(edit.value()) : edit.value());
      case COVARIANCE -> belief.edit(edit.row(), edit.column(), edit.value());
      case PROCESS_NOISE -> processNoise[edge][edit.row()] = edit.notNegative();
      case MEASUREMENT_NOISE -> measurementNoise[edge] = edit.notNegative();
    }
  }

  @Override
  public StrokeSeed seed() {
    return new StrokeSeed(
        nowUs,
        centre(),
        amplitude(),
        phase(),
        2 * Math.PI * frequencyHz(),
        0.02,
        0,
        new double[0],
        new double[0]);
  }

  @Override
  public boolean isLost(long timeUs) {
    return timeUs - lastEventUs > 30_000
        || filters[0].monitor.lockLost()
        || filters[1].monitor.lockLost();
  }
}
