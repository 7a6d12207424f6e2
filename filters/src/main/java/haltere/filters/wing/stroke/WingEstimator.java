package haltere.filters.wing.stroke;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingNoiseSettings;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingTrackerSettings;
import java.util.Arrays;
import java.util.List;

/**
 * Estimates the stroke of a wing with one {@link StrokeEkf} over both its edges: gathers events for
 * a few tens of microseconds into one update for each edge, learns what events are worth ({@link
 * WingEventNoise}), follows the hinge ({@link HingeTracker}), lets the frequency run in manoeuvres,
 * and takes the latency out of what it says.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class WingEstimator implements SideEstimator {
  private static final int SLOW_US = 1000;
  private static final int HINGE_US = 10_000;

  /** Events of one beat repeat each other's errors: so many of them count for one. */
  private static final double REPEATING = 3;

  /** What a wing's estimate is usually wrong by from the heading that its angles refer to. */
  private static final double SYSTEMATIC_RAD = 0.0092;

  final StrokeEkf filter;
  final WingEventNoise noise;
  private final StrokeFrame frame;
  private final WingSide side;
  private WingNoiseSettings settings;
  private WingNoiseSettings appliedNoise;
  private WingFilterSettings options;
  private final BeatClock clock;
  private final StrokeShape shape = new StrokeShape();
  private final HingeTracker hinge = new HingeTracker();
  private final LockJudge judge = new LockJudge();
  private final FrequencyNoise frequencyNoise = new FrequencyNoise();
  private WingEstimator other;
  private boolean followsHinge;
  private final double[] density;
  private double steadyFrequency;
  private double averagingS;

  private long timeUs;
  private long covarianceUs;
  private long slowUs;
  private long hingeUs;
  private long lastTakenUs;
  private long firstPendingUs;
  private int pending;
  private final EdgeSums[] sums = {new EdgeSums(0), new EdgeSums(1)};
  private final long[] taken = new long[2];
  private final double[] expected = new double[2];
  private double expectedAngle;

  /**
   * An estimator that has to be {@link #launch launched}.
   *
   * @param side which wing
   * @param frame where it is hinged; follows the events if the settings say so
   * @param settings of the tracker
   * @param beats takes the beats
   */
  public WingEstimator(
      WingSide side, StrokeFrame frame, WingTrackerSettings settings, BeatListener beats) {
    this.side = side;
    this.frame = frame;
    clock = new BeatClock(side, beats);
    filter = new StrokeEkf(settings.filter().harmonics());
    noise = new WingEventNoise(settings.filter().gateSd(), settings.noise().measurement());
    density = new double[filter.size];
    apply(settings);
  }

  @Override
  public final void apply(WingTrackerSettings changed) {
    settings = changed.noise();
    options = changed.filter();
    followsHinge = changed.place().followsHinges();
    averagingS = options.averagingUs() * 1e-6;
    if (settings.equals(appliedNoise)) {
      noise.apply(options.gateSd(), noise.fixed());
      return;
    }
    appliedNoise = settings;
    noise.apply(options.gateSd(), settings.measurement());
    density[StrokeEkf.CENTRE] = settings.centre();
    density[StrokeEkf.AMPLITUDE] = settings.amplitude();
    density[StrokeEkf.PHASE] = settings.phase();
    steadyFrequency = settings.frequency();
    density[StrokeEkf.OMEGA] = steadyFrequency;
  }

  /**
   * Says which wing is of the same fly, seen by the same camera.
   *
   * @param wing the other one; null if none is tracked
   */
  public void besides(WingEstimator wing) {
    other = wing;
    frequencyNoise.besides(wing == null ? null : wing.frequencyNoise);
  }

  /**
   * Begins with a stroke, as sure of it as a search is.
   *
   * @param atUs when, microseconds
   * @param seed the stroke
   */
  public void launch(long atUs, StrokeSeed seed) {
    filter.launch(seed.state(filter.harmonics, atUs), StrokeSeed.sd(filter.harmonics));
    timeUs = atUs;
    covarianceUs = atUs;
    slowUs = atUs;
    hingeUs = atUs;
    lastTakenUs = atUs;
    density[StrokeEkf.OMEGA] = steadyFrequency;
    noise.reset();
    sums[0].clear();
    sums[1].clear();
    Arrays.fill(taken, 0);
    pending = 0;
    Arrays.fill(expected, 0);
    frequencyNoise.launch();
    judge.launch();
    hinge.launch(0.3);
    shape.of(filter);
    clock.launch(phase());
  }

  @Override
  public boolean event(long atUs, boolean on) {
    if (pending > 0 && (atUs - firstPendingUs) * 1e-6 >= averagingS) {
      flush();
    }
    turnTo(atUs);
    double[] x = filter.x;
    double c = filter.cos;
    double s = filter.sin;
    if (on) {
      double behind = c * filter.lagCos + s * filter.lagSin;
      s = s * filter.lagCos - c * filter.lagSin;
      c = behind;
    }
    double middle = filter.angleWithSlope(c, s);
    double slope = filter.slopeThere;
    double speed = slope * x[StrokeEkf.OMEGA];
    double ahead = slope >= 0 == on ? -x[StrokeEkf.WIDTH] : x[StrokeEkf.WIDTH];
    expectedAngle = middle + ahead;
    double y = frame.angle() - expectedAngle;
    if (y > Math.PI) {
      y -= 2 * Math.PI;
    } else if (y < -Math.PI) {
      y += 2 * Math.PI;
    }
    int edge = on ? 1 : 0;
    EventNoise worth = noise.of(edge);
    double variance = worth.variance(frame.square, speed);
    double full = x[StrokeEkf.AMPLITUDE] * x[StrokeEkf.OMEGA];
    double belief = worth.judge(y, expected[edge], speed, full);
    noise.count(edge, y, belief > 0);
    if (belief == 0) {
      if (noise.isOneOfTooMany(y)) {
        // the phase has run away so far that only events that happen to agree are taken in
        double most = options.gateSd() * Math.sqrt(variance + expected[edge]);
        frequencyNoise.add(Math.max(-most, Math.min(most, y)), slope / variance, slope);
      }
      return false;
    }
    lastTakenUs = atUs;
    double w = belief / variance;
    double ws = w * slope;
    frequencyNoise.add(y, ws, slope);
    if (followsHinge) {
      // the residual counts by its distance on the sensor, which changes with the hinge as well
      double gx = (y * frame.dx - frame.turn() * frame.dy) / frame.square;
      double gy = (y * frame.dy + frame.turn() * frame.dx) / frame.square;
      hinge.add(w, y, gx, gy, s, slope);
    }
    if (pending == 0) {
      firstPendingUs = atUs;
    }
    pending++;
    taken[edge]++;
    sums[edge].add(w, y, c, s);
    return true;
  }

  private void turnTo(long atUs) {
    if (atUs != timeUs) {
      filter.turn(filter.x[StrokeEkf.OMEGA] * ((atUs - timeUs) * 1e-6));
      timeUs = atUs;
    }
  }

  private void flush() {
    if (pending > 0) {
      pending = 0;
      predict();
      filter.mark();
      expected[0] = sums[0].update(filter, expected[0]);
      expected[1] = sums[1].update(filter, expected[1]);
      filter.settle();
    }
    if (timeUs - hingeUs >= HINGE_US) {
      followHinge();
    }
    if (timeUs - slowUs >= SLOW_US) {
      slowStep();
    }
  }

  private void predict() {
    if (timeUs > covarianceUs) {
      filter.predictCovariance((timeUs - covarianceUs) * 1e-6, density);
      covarianceUs = timeUs;
    }
  }

  private void followHinge() {
    double dtS = (timeUs - hingeUs) * 1e-6;
    hingeUs = timeUs;
    if (followsHinge && hinge.solve(dtS, settings.hingePx2PerS(), REPEATING, frame.isByHand())) {
      frame.shift(hinge.shiftX, hinge.shiftY);
      filter.x[StrokeEkf.CENTRE] += hinge.centreShift;
      filter.x[StrokeEkf.AMPLITUDE] += hinge.amplitudeShift;
      filter.turn(hinge.phaseShift);
    }
  }

  private void slowStep() {
    double dtS = (timeUs - slowUs) * 1e-6;
    slowUs = timeUs;
    frequencyNoise.look(dtS, filter, settings.manoeuvre());
    density[StrokeEkf.OMEGA] = steadyFrequency + frequencyNoise.added();
    StrokeMemory.forget(filter, dtS, settings.rateSd());
    judge.look(
        dtS,
        taken[0] + taken[1],
        filter.x[StrokeEkf.OMEGA],
        filter.x[StrokeEkf.AMPLITUDE],
        noise.excess());
    shape.of(filter);
    clock.look(timeUs, phase(), filter.x[StrokeEkf.OMEGA], shape);
  }

  @Override
  public boolean isLost(long atUs) {
    double periodUs = 2e6 * Math.PI / Math.max(100, filter.x[StrokeEkf.OMEGA]);
    return judge.isLost() || atUs - lastTakenUs > Math.max(12_000, 3 * periodUs);
  }

  @Override
  public void advance(long toUs) {
    flush();
    if (toUs > timeUs) {
      turnTo(toUs);
      predict();
      flush();
    }
  }

  @Override
  public StrokeSeed seed() {
    int terms = filter.harmonics - 1;
    double[] cosines = new double[terms];
    double[] sines = new double[terms];
    for (int k = 0; k < terms; k++) {
      cosines[k] = filter.x[StrokeEkf.SERIES + 2 * k];
      sines[k] = filter.x[StrokeEkf.SERIES + 2 * k + 1];
    }
    return new StrokeSeed(
        timeUs,
        filter.x[StrokeEkf.CENTRE],
        filter.x[StrokeEkf.AMPLITUDE],
        filter.x[StrokeEkf.PHASE],
        filter.x[StrokeEkf.OMEGA],
        filter.x[StrokeEkf.WIDTH],
        filter.x[StrokeEkf.LAG],
        cosines,
        sines);
  }

  /**
   * Turns the frame; the centre stays where it is on the sensor.
   *
   * @param by counterclockwise, radians
   */
  public void turnHeading(double by) {
    frame.setHeading(frame.headingRad() + by);
    filter.x[StrokeEkf.CENTRE] -= frame.turn() * by;
  }

  private double fullSpeed() {
    return filter.x[StrokeEkf.AMPLITUDE] * filter.x[StrokeEkf.OMEGA];
  }

  private double lagS() {
    return CameraLatency.lagS(filter, other == null ? null : other.filter);
  }

  private double ahead() {
    return CameraLatency.seconds(options.latencyUs(), lagS(), fullSpeed())
        * filter.x[StrokeEkf.OMEGA];
  }

  @Override
  public double angle() {
    return filter.angleAfter(ahead());
  }

  @Override
  public double edgeAngle(int edge) {
    double ahead = ahead();
    double half = filter.slopeAfter(ahead) >= 0 == (edge == 0) ? 1 : -1;
    return filter.angleAfter(ahead) + half * filter.x[StrokeEkf.WIDTH];
  }

  @Override
  public double centre() {
    return filter.x[StrokeEkf.CENTRE];
  }

  @Override
  public double amplitude() {
    shape.of(filter);
    return shape.amplitude();
  }

  @Override
  public double phase() {
    double phase = filter.x[StrokeEkf.PHASE] + ahead() - shape.crossingRad;
    double turns = phase / (2 * Math.PI);
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public double phaseAt(double atUs) {
    return phase() + filter.x[StrokeEkf.OMEGA] * (atUs - timeUs) * 1e-6;
  }

  @Override
  public double frequencyHz() {
    return filter.x[StrokeEkf.OMEGA] / (2 * Math.PI);
  }

  @Override
  public double sdAngle() {
    filter.look(filter.cos, filter.sin, 0);
    double speed = filter.slope(filter.cos, filter.sin) * filter.x[StrokeEkf.OMEGA];
    double late = CameraLatency.sdSeconds(options.latencyUs()) * speed;
    return Math.sqrt(
        Math.max(0, filter.expectedVariance()) + SYSTEMATIC_RAD * SYSTEMATIC_RAD + late * late);
  }

  @Override
  public double sdFrequencyHz() {
    double variance = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
    return Math.sqrt(frequencyNoise.variance(variance)) / (2 * Math.PI);
  }

  @Override
  public double nis() {
    return noise.nis();
  }

  @Override
  public double expected() {
    return expectedAngle;
  }

  @Override
  public List<WingFilterState> filters() {
    double[] q = density.clone();
    q[StrokeEkf.OMEGA] = steadyFrequency;
    return List.of(FilterNumbers.of(side, filter, q, noise, taken[0] + taken[1]));
  }

  @Override
  public void edit(WingFilterEdit edit) {
    flush();
    switch (edit.table()) {
      case STATE -> filter.set(edit.row(), edit.value());
      case COVARIANCE -> filter.belief.edit(edit.row(), edit.column(), edit.value());
      case PROCESS_NOISE -> {
        density[edit.row()] = edit.notNegative();
        if (edit.row() == StrokeEkf.OMEGA) {
          steadyFrequency = edit.value();
        }
      }
      case MEASUREMENT_NOISE -> noise.apply(options.gateSd(), edit.notNegative());
    }
  }

  @Override
  public long events(int edge) {
    return taken[edge];
  }
}
