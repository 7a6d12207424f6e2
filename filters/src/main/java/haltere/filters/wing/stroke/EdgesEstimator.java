package haltere.filters.wing.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.FourStateEkf;
import haltere.filters.estimation.Gate;
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
  private final FourStateEkf[] filters = new FourStateEkf[2];

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
      filters[edge] = new FourStateEkf(gate(options.gateSd()), LOST_AFTER);
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
      filters[edge].setState(seed.centre(), amplitude, Angles.wrapPi(phase), seed.omega());
      filters[edge].setVariances(START_VARIANCE, 1e-9, START_VARIANCE, START_VARIANCE);
      if (!knowsPhase) {
        filters[edge].setCovariance(2, 3, START_COVARIANCE);
      }
      lastUs[edge] = atUs;
      lastPhase[edge] = phase(edge);
    }
  }

  @Override
  public boolean event(long timeUs, boolean on) {
    int edge = on ? 1 : 0;
    lastEventUs = timeUs;
    taken[edge]++;
    FourStateEkf ekf = filters[edge];
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
    double sin = Math.sin(ekf.x2());
    double cos = Math.cos(ekf.x2());
    double y = Angles.wrapPi(angle - (ekf.x0() + ekf.x1() * sin));
    expected = angle - y;
    ekf.update(y, 1, sin, ekf.x1() * cos, 0, measurementNoise(edge));
    mend(ekf);
    if (edge == 0) {
      watchBeat(atUs);
    }
    return true;
  }

  private double measurementNoise(int edge) {
    return measurementNoise[edge] > 0 ? measurementNoise[edge] : USUAL_MEASUREMENT;
  }

  private void predict(int edge, long timeUs) {
    FourStateEkf ekf = filters[edge];
    double dtS = (timeUs - lastUs[edge]) * US;
    if (dtS > 0) {
      ekf.predict(0, 0, 0, 0, 0, dtS);
      addNoise(ekf, processNoise[edge], dtS);
      lastUs[edge] = timeUs;
    }
  }

  private void addNoise(FourStateEkf ekf, double[] q, double dtS) {
    if (isByUpdate()) {
      // the source's table, in which phase and frequency have all of their noise in common
      ekf.addNoise(q[0], q[1], q[2], q[3]);
      ekf.addPairNoise(0, Math.sqrt(q[2] * q[3]));
    } else {
      double square = dtS * dtS;
      ekf.addNoise(q[0] * dtS, q[1] * dtS, q[2] * dtS + q[3] * dtS * square / 3, q[3] * dtS);
      ekf.addPairNoise(0, q[3] * square / 2);
    }
  }

  /** Keeps the phase small, so that it stays exact, and the amplitude positive. */
  private static void mend(FourStateEkf ekf) {
    double phase = ekf.x2();
    double amplitude = ekf.x1();
    if (Math.abs(phase) > 4 * Math.PI || amplitude < 0) {
      if (amplitude < 0) {
        phase += Math.PI;
        amplitude = -amplitude;
      }
      ekf.setState(ekf.x0(), amplitude, Angles.wrapPi(phase), ekf.x3());
    }
  }

  private void watchBeat(long timeUs) {
    double phase = phase(0);
    if (phase < lastPhase[0] - Math.PI) {
      double passedUs = timeUs - phase / Math.max(1, filters[0].x3()) * 1e6;
      beats.beat(
          side, passedUs, passedUs - lastPassedUs, centre() - amplitude(), centre() + amplitude());
      lastPassedUs = passedUs;
      lastPhase[0] = phase;
    } else if (phase - lastPhase[0] < Math.PI) {
      lastPhase[0] = Math.max(lastPhase[0], phase);
    }
  }

  private double phase(int edge) {
    double turns = filters[edge].x2() / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public void advance(long timeUs) {
    nowUs = timeUs;
  }

  private double phaseNow(int edge) {
    FourStateEkf ekf = filters[edge];
    return ekf.x2()
        + ekf.x3()
            * ((nowUs - lastUs[edge]) * US + CameraLatency.seconds(options.latencyUs(), 0, 1));
  }

  @Override
  public double angle() {
    return (edgeAngle(0) + edgeAngle(1)) / 2;
  }

  @Override
  public double edgeAngle(int edge) {
    return filters[edge].x0() + filters[edge].x1() * Math.sin(phaseNow(edge));
  }

  @Override
  public double centre() {
    return (filters[0].x0() + filters[1].x0()) / 2;
  }

  @Override
  public double amplitude() {
    return (Math.abs(filters[0].x1()) + Math.abs(filters[1].x1())) / 2;
  }

  @Override
  public double phase() {
    double turns = phaseNow(0) / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public double phaseAt(double timeUs) {
    return phase() + 2 * Math.PI * frequencyHz() * (timeUs - nowUs) * US;
  }

  @Override
  public double frequencyHz() {
    return (filters[0].x3() + filters[1].x3()) / (4 * Math.PI);
  }

  @Override
  public double sdAngle() {
    FourStateEkf ekf = filters[0];
    double sin = Math.sin(ekf.x2());
    double slope = ekf.x1() * Math.cos(ekf.x2());
    double variance =
        ekf.covariance(0, 0)
            + sin * sin * ekf.covariance(1, 1)
            + slope * slope * ekf.covariance(2, 2)
            + 2 * (sin * ekf.covariance(0, 1) + slope * ekf.covariance(0, 2))
            + 2 * sin * slope * ekf.covariance(1, 2);
    return Math.sqrt(Math.max(0, variance) / 2);
  }

  @Override
  public double sdFrequencyHz() {
    return Math.sqrt(filters[0].covariance(3, 3) / 2) / (2 * Math.PI);
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
    FourStateEkf ekf = filters[edge];
    double[] p = new double[16];
    for (int i = 0; i < 16; i++) {
      p[i] = ekf.covariance(i / 4, i % 4);
    }
    return new WingFilterState(
        WingPart.edge(side.ordinal(), edge),
        NAMES,
        UNITS,
        new double[] {ekf.x0(), ekf.x1(), ekf.x2(), ekf.x3()},
        p,
        processNoise[edge],
        measurementNoise(edge),
        false,
        ekf.nis(),
        taken[edge]);
  }

  @Override
  public void edit(WingFilterEdit edit) {
    int edge = edit.part() == WingPart.edge(side.ordinal(), 0) ? 0 : 1;
    FourStateEkf ekf = filters[edge];
    switch (edit.table()) {
      case STATE -> {
        double[] x = {ekf.x0(), ekf.x1(), ekf.x2(), ekf.x3()};
        x[edit.row()] = edit.value();
        ekf.setState(x[0], x[1], Angles.wrapPi(x[2]), x[3]);
      }
      case COVARIANCE -> ekf.setCovariance(edit.row(), edit.column(), edit.value());
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
        || filters[0].monitor().lockLost()
        || filters[1].monitor().lockLost();
  }
}
