package haltere.filters.wing.internal.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/** An estimator for each edge. The wing is the mean of the enabled edges with recent events. */
public final class EdgesEstimator implements SideEstimator {
  private static final double US = 1e-6;

  /** Time without events after which an edge does not count, µs: two of the longest beats. */
  private static final long SILENT_US = 30_000;

  private final WingPart side;
  private final StrokeFrame frame;
  private final BeatListener beats;
  private final EdgeEstimator[] edges = new EdgeEstimator[2];
  private final boolean[] taken = new boolean[2];
  private final boolean filters;
  private double latencyUs;
  private long nowUs;
  private double lastPassedUs;
  private double lagS;

  /**
   * Estimators that have to be {@link #launch launched}.
   *
   * @param frame hinge and direction of the wing
   * @param settings of the tracker
   * @param beats receives the beats
   * @param noise of a Kalman filter of a plain sinusoid for each edge (Cardinale 2006); empty for
   *     running averages, without standard deviations
   */
  public EdgesEstimator(
      StrokeFrame frame,
      WingTrackerSettings settings,
      BeatListener beats,
      Optional<EdgeNoise> noise) {
    this.frame = frame;
    this.beats = beats;
    side = frame.side;
    filters = noise.isPresent();
    for (int edge = 0; edge < 2; edge++) {
      edges[edge] =
          filters
              ? new EdgeFilter(WingPart.edge(side.sideNumber(), edge), noise.get(), settings)
              : new EdgeAverage(settings);
    }
    apply(settings);
  }

  @Override
  public final void apply(WingTrackerSettings settings) {
    latencyUs = filters ? settings.filter().latencyUs() : 0;
    for (int edge = 0; edge < 2; edge++) {
      taken[edge] = settings.output().uses(WingPart.edge(side.sideNumber(), edge));
      edges[edge].apply(settings);
    }
  }

  @Override
  public void launch(long atUs, StrokeSeed seed) {
    nowUs = atUs;
    lastPassedUs = Double.NaN;
    lagS = seed.lagS();
    edges[0].launch(atUs, seed);
    edges[1].launch(atUs, seed);
  }

  @Override
  public double event(long timeUs, boolean on) {
    return event(timeUs, on, frame.angle());
  }

  /**
   * Processes an event with a known stroke angle.
   *
   * @param timeUs microseconds
   * @param on its polarity
   * @param angle stroke angle, not wrapped
   * @return expected stroke angle
   */
  public double event(long timeUs, boolean on, double angle) {
    nowUs = timeUs;
    EdgeEstimator edge = edges[on ? TRAILING : LEADING];
    boolean ended = edge.event(timeUs, angle);
    if (ended && edge == edges[counts(LEADING) ? LEADING : TRAILING]) {
      endBeat();
    }
    return edge.expected;
  }

  /** The beat of the leading edge, or of the trailing edge if the other has no events. */
  private void endBeat() {
    double omega = Math.max(1, mean(edge -> edge.omega));
    double passedUs = nowUs - Angles.wrapPi(wingPhase(nowUs)) / omega / US;
    beats.beat(
        side, passedUs, passedUs - lastPassedUs, mean(edge -> edge.min), mean(edge -> edge.max));
    lastPassedUs = passedUs;
  }

  private boolean counts(int edge) {
    EdgeEstimator e = edges[edge];
    return taken[edge] && nowUs - e.lastEventUs <= SILENT_US && !e.isLost(nowUs);
  }

  /** The only edge that counts, or null if both count. */
  private EdgeEstimator alone() {
    boolean leading = counts(LEADING);
    return leading == counts(TRAILING) ? null : edges[leading ? LEADING : TRAILING];
  }

  private double mean(ToDoubleFunction<EdgeEstimator> value) {
    EdgeEstimator alone = alone();
    return alone != null
        ? value.applyAsDouble(alone)
        : (value.applyAsDouble(edges[0]) + value.applyAsDouble(edges[1])) / 2;
  }

  /** The same for an angle, not wrapped. */
  private double meanAngle(ToDoubleFunction<EdgeEstimator> value) {
    EdgeEstimator alone = alone();
    double from = value.applyAsDouble(alone != null ? alone : edges[0]);
    return alone != null ? from : from + Angles.wrapPi(value.applyAsDouble(edges[1]) - from) / 2;
  }

  /** Standard deviation of a mean of independent values. */
  private double sdOfMean(ToDoubleFunction<EdgeEstimator> variance) {
    double mean = mean(variance);
    return Math.sqrt(alone() == null ? mean / 2 : mean);
  }

  private double wingPhase(double atUs) {
    return meanAngle(edge -> edge.phase(atUs));
  }

  @Override
  public void advance(long timeUs) {
    nowUs = timeUs;
  }

  @Override
  public WingEstimate estimate(int part) {
    double atUs = nowUs + latencyUs;
    if (part != WING) {
      EdgeEstimator edge = edges[part];
      return new WingEstimate(
          nowUs,
          WingPart.edge(side.sideNumber(), part),
          Angles.wrapTwoPi(edge.angle(atUs)),
          edge.centre,
          edge.amplitude,
          Angles.wrapTwoPi(edge.phase(atUs)),
          edge.omega / (2 * Math.PI),
          Math.sqrt(edge.angleVariance(atUs)),
          Math.sqrt(edge.omegaVariance()) / (2 * Math.PI),
          edge.taken);
    }
    return new WingEstimate(
        nowUs,
        side,
        Angles.wrapTwoPi(meanAngle(edge -> edge.angle(atUs))),
        mean(edge -> edge.centre),
        mean(edge -> edge.amplitude),
        Angles.wrapTwoPi(wingPhase(atUs)),
        mean(edge -> edge.omega) / (2 * Math.PI),
        sdOfMean(edge -> edge.angleVariance(atUs)),
        sdOfMean(EdgeEstimator::omegaVariance) / (2 * Math.PI),
        edges[0].taken + edges[1].taken);
  }

  @Override
  public double[][] beat(int steps) {
    double[][] angles = new double[2][steps];
    for (int part = 0; part < 2; part++) {
      double stepUs = 2 * Math.PI / edges[part].omega / steps * 1e6;
      for (int step = 0; step < steps; step++) {
        angles[part][step] = edges[part].angle(nowUs + latencyUs + step * stepUs);
      }
    }
    return angles;
  }

  @Override
  public List<WingFilterState> filters() {
    return Stream.of(edges).map(EdgeEstimator::filter).flatMap(Optional::stream).toList();
  }

  @Override
  public void edit(WingFilterEdit edit) {
    edges[edit.part() == WingPart.edge(side.sideNumber(), LEADING) ? LEADING : TRAILING].edit(edit);
  }

  @Override
  public StrokeSeed seed() {
    return StrokeSeed.sinusoid(
        nowUs,
        mean(edge -> edge.centre),
        mean(edge -> edge.amplitude),
        wingPhase(nowUs),
        mean(edge -> edge.omega),
        lagS);
  }

  @Override
  public boolean isLost(long timeUs) {
    boolean none = !counts(LEADING) && !counts(TRAILING);
    return none || filters && (edges[0].isLost(timeUs) || edges[1].isLost(timeUs));
  }
}
