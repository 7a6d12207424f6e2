package haltere.filters.wing.internal.stroke;

import haltere.core.event.EventAddress;
import haltere.filters.estimation.Angles;
import haltere.filters.estimation.ConstMatrix;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingFilterState.Source;
import haltere.filters.wing.WingNoiseSettings;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.util.Arrays;
import java.util.List;

/**
 * Estimates the stroke of a wing with one {@link StrokeEkf} over both edges: combines the events of
 * some tens of microseconds into one update for each edge, estimates their noise ({@link
 * WingEventNoise}), tracks the hinge ({@link HingeTracker}), adapts the noise of the frequency to
 * manoeuvres ({@link FrequencyNoise}) and removes the latency.
 */
public final class WingEstimator implements SideEstimator {
  private static final int SLOW_US = 1000;
  private static final int HINGE_US = 10_000;

  /** Time without events after which an edge does not count: two of the longest beats. */
  private static final int SILENT_US = 30_000;

  /** Number of events of one beat that count as one, since their errors are correlated. */
  private static final double REPEATING = 3;

  /** Standard deviation of an angle from errors of the heading and of the stroke's shape. */
  private static final double SYSTEMATIC_RAD = 0.0092;

  /** Step of a median towards a passage: the resolution of times. */
  private static final double RESOLVED_STEP_S = 1e-6;

  final StrokeEkf filter;
  private WingEventNoise noise;
  private final StrokeFrame frame;
  private final WingPart side;
  private WingNoiseSettings settings;
  private WingNoiseSettings appliedNoise;
  private WingFilterSettings options;
  private final BeatClock clock;
  private final StrokeShape shape = new StrokeShape();
  private final HingeTracker hinge = new HingeTracker();
  private RadialResiduals radial = new RadialResiduals(1);
  private final double[] eventVariances = new double[2];
  private LockMonitor lock = new LockMonitor();
  private FrequencyNoise frequencyNoise = new FrequencyNoise();
  private WingEstimator other;
  private boolean followsHinge;
  private final boolean[] takes = new boolean[2];

  /**
   * Time between the first and the trailing ON event of a passage in mid stroke, which a vein
   * causes: a median over pixels.
   */
  private double resolvedS;

  private int passedAddress = -1;
  private long passedUs;

  /** Process noise of each entry, from the settings or edited. */
  private final double[] q;

  private final boolean[] manual;
  private boolean measurementByHand;
  private final double[] density = new double[StrokeEkf.OMEGA + 1];
  private double averagingS;

  private long timeUs;
  private long covarianceUs;
  private long slowUs;
  private long hingeUs;
  private final long[] lastTakenUs = new long[2];
  private long firstPendingUs;
  private int pending;
  private final EdgeSums[] sums = {new EdgeSums(0), new EdgeSums(1)};
  private final long[] taken = new long[2];
  private final double[] expected = new double[2];

  /**
   * An estimator that has to be {@link #launch launched}.
   *
   * @param frame hinge and direction of the wing; follows the events if set so
   * @param settings of the tracker
   * @param beats receives the beats
   */
  public WingEstimator(StrokeFrame frame, WingTrackerSettings settings, BeatListener beats) {
    side = frame.side;
    this.frame = frame;
    clock = new BeatClock(side, beats);
    filter = new StrokeEkf(settings.filter().harmonics());
    noise = new WingEventNoise(settings.filter().gateSd(), settings.noise().measurement());
    q = new double[filter.size];
    manual = new boolean[filter.size];
    apply(settings);
  }

  @Override
  public final void apply(WingTrackerSettings changed) {
    settings = changed.noise();
    options = changed.filter();
    followsHinge = changed.position().followsHinges();
    for (int edge = 0; edge < 2; edge++) {
      takes[edge] = changed.output().uses(WingPart.edge(side.sideNumber(), edge));
    }
    averagingS = options.averagingUs() * 1e-6;
    if (settings.equals(appliedNoise)) {
      noise.apply(options.gateSd(), noise.of(LEADING).fixed());
      return;
    }
    appliedNoise = settings;
    releaseNoise();
    Arrays.fill(manual, false);
    setProcessNoise();
  }

  private void releaseNoise() {
    measurementByHand = false;
    noise.apply(options.gateSd(), settings.measurement());
  }

  /** Process noise from the settings, except for edited entries. */
  private void setProcessNoise() {
    double[] set = new double[q.length];
    set[StrokeEkf.CENTRE] = settings.centre();
    set[StrokeEkf.AMPLITUDE] = settings.amplitude();
    set[StrokeEkf.PHASE] = settings.phase();
    set[StrokeEkf.OMEGA] = settings.frequency();
    StrokeMemory.setDensities(set, settings.rateSd());
    for (int i = 0; i < q.length; i++) {
      q[i] = manual[i] ? q[i] : set[i];
    }
    System.arraycopy(q, 0, density, 0, density.length);
  }

  /**
   * Sets the other wing of the same fly and camera.
   *
   * @param wing the other one; null if none is tracked
   */
  public void besides(WingEstimator wing) {
    other = wing;
    frequencyNoise.besides(wing == null ? null : wing.frequencyNoise);
  }

  /** {@inheritDoc} The initial covariance is that of a search. */
  @Override
  public void launch(long atUs, StrokeSeed seed) {
    filter.launch(seed.state(filter.harmonics, atUs), StrokeSeed.sd(filter.harmonics));
    timeUs = atUs;
    covarianceUs = atUs;
    slowUs = atUs;
    hingeUs = atUs;
    Arrays.fill(lastTakenUs, atUs);
    density[StrokeEkf.OMEGA] = q[StrokeEkf.OMEGA];
    noise = new WingEventNoise(options.gateSd(), noise.of(LEADING).fixed());
    sums[0].clear();
    sums[1].clear();
    Arrays.fill(taken, 0);
    pending = 0;
    Arrays.fill(expected, 0);
    frequencyNoise = new FrequencyNoise();
    lock = new LockMonitor();
    hinge.launch(0.3);
    radial = new RadialResiduals(frame.outerSquare);
    resolvedS = 0;
    passedAddress = -1;
    shape.of(filter);
    clock.launch(phase());
  }

  @Override
  public double event(long atUs, boolean on) {
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
    double middle = filter.angle(c, s);
    double slope = filter.slopeThere;
    double speed = slope * x[StrokeEkf.OMEGA];
    double ahead = slope >= 0 == on ? -x[StrokeEkf.WIDTH] : x[StrokeEkf.WIDTH];
    double expectedAngle = middle + ahead;
    double y = frame.angle() - expectedAngle;
    if (y > Math.PI) {
      y -= 2 * Math.PI;
    } else if (y < -Math.PI) {
      y += 2 * Math.PI;
    }
    int edge = on ? 1 : 0;
    EventNoise edgeNoise = noise.of(edge);
    double variance = edgeNoise.variance(frame.square, speed);
    double full = x[StrokeEkf.AMPLITUDE] * x[StrokeEkf.OMEGA];
    double belief = edgeNoise.judge(y, expected[edge], speed, full);
    noise.count(edge, y, belief > 0);
    if (belief == 0) {
      if (noise.isExcessRejection(y)) {
        // a diverged phase accepts only events that agree by chance
        double limit = options.gateSd() * Math.sqrt(variance + expected[edge]);
        frequencyNoise.add(Math.max(-limit, Math.min(limit, y)), slope / variance, slope);
      }
      return Double.NaN;
    }
    lastTakenUs[edge] = atUs;
    double w = belief / variance;
    double ws = w * slope;
    frequencyNoise.add(y, ws, slope);
    if (speed * speed > full * full / 2) {
      radial.add(edge, frame.square, y, speed);
      eventVariances[edge] = REPEATING * variance;
    }
    if (followsHinge) {
      // the distance on the sensor changes with the hinge as well
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
    return expectedAngle;
  }

  /**
   * Keeps what a passage of a pixel shows between its edges until the next {@link #step}.
   *
   * @param address of the pixel
   * @param us microseconds between its first and its trailing ON event
   */
  public void passed(int address, long us) {
    passedAddress = address;
    passedUs = us;
  }

  private void takePassage() {
    double off = frame.angle() - filter.x[StrokeEkf.CENTRE];
    if (Math.abs(off) < filter.x[StrokeEkf.AMPLITUDE] * Math.sqrt(0.5)) {
      double step = RESOLVED_STEP_S * Math.signum(passedUs * 1e-6 - resolvedS);
      resolvedS = Math.max(0, resolvedS + step);
    }
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
    if (followsHinge && hinge.solve(dtS, settings.hingePx2PerS(), REPEATING, frame.isManual)) {
      frame.shift(hinge.shift.get(0), hinge.shift.get(1));
      filter.x[StrokeEkf.CENTRE] += hinge.stroke.get(0);
      filter.x[StrokeEkf.AMPLITUDE] += hinge.stroke.get(1);
      filter.turn(hinge.stroke.get(2));
    }
  }

  /** Update of each millisecond, with the other wing at the same time. */
  public void step() {
    if (timeUs - slowUs < SLOW_US) {
      return;
    }
    double dtS = (timeUs - slowUs) * 1e-6;
    slowUs = timeUs;
    frequencyNoise.update(dtS, filter, settings.manoeuvre());
    density[StrokeEkf.OMEGA] =
        q[StrokeEkf.OMEGA] + (manual[StrokeEkf.OMEGA] ? 0 : frequencyNoise.added());
    boolean both = hasBothEdges();
    StrokeMemory.forget(filter, dtS, q, both);
    boolean spread = CameraLatency.isWide(noise.of(LEADING).timingSdS(), fullSpeed());
    radial.update(dtS, apartS(filter.x[StrokeEkf.LAG]), eventVariances, spread);
    if (passedAddress >= 0
        && frame.look(EventAddress.x(passedAddress), EventAddress.y(passedAddress))) {
      takePassage();
    }
    passedAddress = -1;
    if (!both) {
      copyFromOther();
    }
    lock.update(
        dtS,
        taken[0] + taken[1],
        filter.x[StrokeEkf.OMEGA],
        filter.x[StrokeEkf.AMPLITUDE],
        noise.excess());
    shape.of(filter);
    clock.update(timeUs, phase(), filter.x[StrokeEkf.OMEGA], shape);
  }

  /**
   * Copies unobservable parameters from the other wing if that has events of both edges and this
   * one of one only: the lag of ON events, and for ON events alone also the waveform.
   */
  private void copyFromOther() {
    if (other == null || !other.hasBothEdges()) {
      return;
    }
    double[] x = filter.x;
    double[] from = other.filter.x;
    double longer = from[StrokeEkf.LAG] - x[StrokeEkf.LAG];
    x[StrokeEkf.LAG] = from[StrokeEkf.LAG];
    if (lastTakenUs[TRAILING] > lastTakenUs[LEADING]) {
      filter.turn(x[StrokeEkf.OMEGA] * longer);
      for (int i = StrokeEkf.SERIES; i < filter.size; i++) {
        x[i] = from[i] * x[StrokeEkf.AMPLITUDE] / from[StrokeEkf.AMPLITUDE];
        filter.belief.scale(i, 0);
      }
    }
  }

  /** Whether both edges are enabled and have recent events. */
  private boolean hasBothEdges() {
    return takes[0] && takes[1] && Math.abs(lastTakenUs[0] - lastTakenUs[1]) < SILENT_US;
  }

  @Override
  public boolean isLost(long atUs) {
    double periodUs = 2e6 * Math.PI / Math.max(100, filter.x[StrokeEkf.OMEGA]);
    return lock.isLost()
        || atUs - Math.max(lastTakenUs[0], lastTakenUs[1]) > Math.max(12_000, 3 * periodUs);
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
   * Rotates the frame; the centre keeps its direction on the sensor.
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

  /**
   * Phase by which estimates are ahead of the events. OFF events of a wide wing on slow pixels come
   * between the middle of the passage and its end. What a passage resolves is no delay.
   */
  private double ahead() {
    double lagS = lagS();
    double fast = passageShare(lagS);
    double slowS = (1 - fast) * lagS;
    double wide = Math.min(radial.wideShare, other == null ? 1 : other.radial.wideShare);
    double lateS = CameraLatency.seconds(options.latencyUs(), (1 - wide) * slowS, fullSpeed());
    double passageS = fast * lagS + radial.chordShare * resolvedS;
    return (lateS + wide * slowS / 4 - passageS / 2) * filter.x[StrokeEkf.OMEGA];
  }

  /** Half of the mean time between the edges in mid stroke, for a lag of ON events. */
  private double apartS(double lagS) {
    return filter.x[StrokeEkf.WIDTH] * Math.sqrt(2) / fullSpeed() + lagS / 2;
  }

  /**
   * Probability that the lag of ON events is the passage of a chord over fast pixels: odds by
   * radius times odds by times.
   */
  private double passageShare(double lagS) {
    if (!hasBothEdges()) {
      return 0;
    }
    double chord = radial.chordShare;
    // slow pixels scatter the times of both edges, the shape of a wing those of one
    double spreadS = Math.sqrt(noise.of(LEADING).timingSdS() * noise.of(TRAILING).timingSdS());
    double fast = CameraLatency.fastShare(lagS + chord * resolvedS, spreadS);
    double both = chord * fast;
    return both == 0 ? 0 : radial.answeredShare * both / (both + (1 - chord) * (1 - fast));
  }

  /**
   * Variance of the time from the middle of the wing to its events, which is within half of the
   * time between the edges. For fast pixels it is the second moment about the end of this interval,
   * for slow ones the bound by mean and interval (Bhatia and Davis 2000). Added: the choice between
   * both, the scatter of OFF events (Popoviciu 1935) and the curvature of the middle.
   */
  private double passageVariance(double lagS) {
    if (!hasBothEdges()) {
      return 0;
    }
    double fast = passageShare(lagS);
    double wide = Math.max(radial.notNarrowShare, other == null ? 0 : other.radial.notNarrowShare);
    double choice = 1 + wide / 2;
    double apartS = apartS(lagS + radial.chordShare * resolvedS);
    double spreadS = noise.of(LEADING).timingSdS();
    double square =
        apartS * apartS
            + CameraLatency.lagVariance(filter, other == null ? null : other.filter) / 4;
    return (fast / 2 + (1 - fast) * (wide * 0.75 + fast * choice * choice)) * square
        + 3 * wide * spreadS * spreadS
        + radial.bendVariance;
  }

  @Override
  public WingEstimate estimate(int part) {
    double angle = filter.angleAfter(ahead());
    boolean isRising = filter.slopeThere >= 0;
    // on which side of the wing's middle: 1 nearer to the tail, -1 nearer to the head
    int at = part == WING ? 0 : isRising == (part == LEADING) ? 1 : -1;
    // the leading edge is half a width ahead of the wing on both ways, the trailing edge behind it
    double wider = part == WING ? 0 : part == LEADING ? 1 : -1;
    double width = filter.x[StrokeEkf.WIDTH];
    shape.of(filter);
    return new WingEstimate(
        timeUs,
        part == WING ? side : WingPart.edge(side.sideNumber(), part),
        Angles.wrapTwoPi(angle + at * width),
        filter.x[StrokeEkf.CENTRE],
        shape.amplitude() + wider * width,
        phase(),
        filter.x[StrokeEkf.OMEGA] / (2 * Math.PI),
        sdAngle(at),
        sdFrequencyHz(),
        part == WING ? taken[0] + taken[1] : taken[part]);
  }

  @Override
  public double[][] beat(int steps) {
    double[][] angles = new double[2][steps];
    double width = filter.x[StrokeEkf.WIDTH];
    double stepCos = Math.cos(2 * Math.PI / steps);
    double stepSin = Math.sin(2 * Math.PI / steps);
    double phase = filter.x[StrokeEkf.PHASE] + ahead();
    double c = Math.cos(phase);
    double s = Math.sin(phase);
    for (int step = 0; step < steps; step++) {
      double angle = filter.angle(c, s);
      double leading = filter.slopeThere >= 0 ? width : -width;
      angles[LEADING][step] = angle + leading;
      angles[TRAILING][step] = angle - leading;
      double next = c * stepCos - s * stepSin;
      s = s * stepCos + c * stepSin;
      c = next;
    }
    return angles;
  }

  private double phase() {
    return Angles.wrapTwoPi(filter.x[StrokeEkf.PHASE] + ahead() - shape.crossingRad);
  }

  /** Standard deviation of the angle of the middle, 0, or of an edge on one of its sides. */
  private double sdAngle(int at) {
    double variance = filter.angleVariance(at);
    double speed = filter.slope(filter.cos, filter.sin) * filter.x[StrokeEkf.OMEGA];
    double lagS = lagS();
    double late = CameraLatency.variance(hasBothEdges() ? 0 : lagS) + passageVariance(lagS);
    return Math.sqrt(
        Math.max(0, variance) + SYSTEMATIC_RAD * SYSTEMATIC_RAD + late * speed * speed);
  }

  private double sdFrequencyHz() {
    double variance = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
    return Math.sqrt(frequencyNoise.variance(variance)) / (2 * Math.PI);
  }

  @Override
  public List<WingFilterState> filters() {
    double[] present = q.clone();
    System.arraycopy(density, 0, present, 0, density.length);
    Source[] sources = new Source[q.length];
    for (int i = 0; i < q.length; i++) {
      sources[i] = manual[i] ? Source.MANUAL : Source.SETTINGS;
    }
    if (settings.manoeuvre() > 0 && !manual[StrokeEkf.OMEGA]) {
      sources[StrokeEkf.OMEGA] = Source.ESTIMATOR;
    }
    Source measurement =
        measurementByHand
            ? Source.MANUAL
            : noise.of(LEADING).fixed() == 0 ? Source.ESTIMATOR : Source.SETTINGS;
    return List.of(
        new WingFilterState(
            side,
            FilterNumbers.of(FilterNumbers.NAMES, filter.size),
            FilterNumbers.of(FilterNumbers.UNITS, filter.size),
            ConstMatrix.copyOf(filter.belief.mean()),
            ConstMatrix.copyOf(filter.belief.covariance()),
            ConstMatrix.column(present),
            FilterNumbers.of(FilterNumbers.DENSITY_UNITS, filter.size),
            List.of(sources),
            noise.of(LEADING).present(),
            measurement,
            noise.nis(),
            taken[0] + taken[1]));
  }

  @Override
  public void edit(WingFilterEdit edit) {
    flush();
    int row = edit.row();
    switch (edit.table()) {
      case STATE -> filter.set(row, edit.value());
      case COVARIANCE -> filter.belief.edit(row, edit.column(), edit.value());
      case PROCESS_NOISE -> {
        manual[row] = !edit.restoresAutomatic();
        q[row] = edit.notNegative();
        setProcessNoise();
      }
      case MEASUREMENT_NOISE -> {
        if (edit.restoresAutomatic()) {
          releaseNoise();
        } else {
          noise.apply(options.gateSd(), edit.notNegative());
          measurementByHand = edit.value() > 0;
        }
      }
    }
  }
}
