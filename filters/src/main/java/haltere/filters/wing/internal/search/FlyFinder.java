package haltere.filters.wing.internal.search;

import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSearchSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import java.util.function.Consumer;
import org.apache.commons.statistics.distribution.TDistribution;

/**
 * Finds a fly in the events of a few beats: 2-means for the wings, {@link BeatSpectrum} for beat
 * and body axis (repeated without cells that do not follow the beat), {@link HingeLines} for the
 * hinges, {@link StrokeFit} for the strokes. The head is where the wings stay further from the body
 * line.
 */
final class FlyFinder {
  private static final int MIN_SUPPORTED = 80;
  private static final int MAX_SEARCHES = 3;
  private static final double MIN_EXPLAINED = 0.03;
  private static final double MIN_SHARE = 0.32;
  private static final double OTHER_AXIS_RAD = 0.35;

  /** Distance of the hinge from the middle of a single wing's events, as a share of their reach. */
  private static final double SINGLE_SHARE = 0.6;

  private static final double SINGLE_INLIERS = 0.45;

  /** Cosine of the largest phase between the wings. */
  private static final double MIN_TOGETHER = 0.5;

  /** Radius of the region of interest over the size of the fly. */
  private static final double REGION_SLACK = 1.05;

  final StrokeSample sample;
  private final SensorGeometry geometry;
  private final Consumer<WingTrackerState> steps;
  private final BeatSpectrum spectrum = new BeatSpectrum();
  private final TwoMeans means = new TwoMeans();
  private final HingeLines lines = new HingeLines();
  private final SideSplit split;
  private final WingPairFit bodyLine = new WingPairFit();
  private final StrokeFit[] fits = {new StrokeFit(), new StrokeFit()};
  private final StrokeFit[] otherEnd = {new StrokeFit(), new StrokeFit()};
  private final double[] px;
  private final double[] py;
  private final boolean[] fitted = new boolean[2];
  private double fittedAxis;
  private double outerPx;

  FlyFinder(SensorGeometry geometry, int capacity, Consumer<WingTrackerState> steps) {
    this.geometry = geometry;
    this.steps = steps;
    sample = new StrokeSample(geometry.width(), geometry.height(), capacity);
    split = new SideSplit(sample, capacity);
    px = new double[capacity];
    py = new double[capacity];
  }

  /** Searches the events of the last window; null if there is no fly. */
  FoundFly find(RecentEvents events, long nowUs, WingSearchSettings settings) {
    sample.take(events, nowUs - settings.windowUs());
    if (sample.supportedCount < MIN_SUPPORTED) {
      return null;
    }
    for (int look = 0; look < MAX_SEARCHES; look++) {
      if (look > 0) {
        sample.requireBeat(2 * Math.PI * spectrum.frequencyHz);
      }
      if (sample.supportedCount < MIN_SUPPORTED / 2 || !look(settings)) {
        return null;
      }
    }
    double byMeans =
        Math.atan2(means.secondY - means.firstY, means.secondX - means.firstX) + Math.PI / 2;
    double size = Math.hypot(means.firstX - means.secondX, means.firstY - means.secondY);
    publish(nowUs, Phase.TWO_MEANS, Double.NaN, Angles.wrapPi(byMeans), size);
    if (spectrum.explained < MIN_EXPLAINED) {
      return null;
    }
    publish(nowUs, Phase.BEAT, spectrum.frequencyHz, spectrum.axisRad, size);
    if (!fitBest(byMeans)) {
      return null;
    }
    FoundFly fly = conclude();
    StrokeSeed seed = fly.seeds()[fly.seeds()[0] != null ? 0 : 1];
    double beatHz = seed.omega() / (2 * Math.PI);
    FlyGeometry found = fly.geometry();
    publish(nowUs, Phase.HINGES, beatHz, found, Double.NaN);
    publish(nowUs, Phase.HEAD_AND_TAIL, beatHz, found, found.headTailConfidence());
    return fly;
  }

  /** Reports a step before the hinges are found. */
  private void publish(long nowUs, Phase phase, double hz, double heading, double size) {
    double x = (means.firstX + means.secondX) / 2;
    double y = (means.firstY + means.secondY) / 2;
    FlyGeometry about = new FlyGeometry(x, y, heading, size, x, y, x, y, Double.NaN, nowUs);
    publish(nowUs, phase, hz, about, Double.NaN);
  }

  private void publish(long nowUs, Phase phase, double hz, FlyGeometry g, double confidence) {
    steps.accept(WingTrackerState.of(nowUs, phase, sample.supportedCount, hz, g, confidence));
  }

  /** Searches the beat. A given frequency is used unless another one explains clearly more. */
  private boolean look(WingSearchSettings settings) {
    int n = 0;
    spectrum.clear();
    for (int i = 0; i < sample.size; i++) {
      if (sample.supported[i]) {
        px[n] = sample.x[i];
        py[n++] = sample.y[i];
        spectrum.add(sample.timeS[i], sample.x[i], sample.y[i]);
      }
    }
    if (!means.divide(px, py, n, geometry.width(), geometry.height())) {
      return false;
    }
    double minHz = Math.min(settings.minFrequencyHz(), settings.maxFrequencyHz());
    double maxHz = Math.max(settings.minFrequencyHz(), settings.maxFrequencyHz());
    double givenHz = settings.startFrequencyHz();
    boolean found = spectrum.search(minHz, maxHz);
    if (givenHz == 0 || !found) {
      return found;
    }
    double explained = spectrum.explained;
    return !spectrum.search(givenHz * 0.8, givenHz * 1.25)
        || spectrum.explained * BeatSpectrum.SIGNIFICANT_RATIO >= explained
        || spectrum.search(minHz, maxHz);
  }

  /** Fits along the axis of the beat and, if it differs, of 2-means; keeps the better fit. */
  private boolean fitBest(double byMeans) {
    double axis = spectrum.axisRad;
    double score = fit(axis);
    if (Math.abs(Angles.wrapHalfPi(byMeans - axis)) > OTHER_AXIS_RAD) {
      double other = fit(byMeans);
      score = other > score ? other : fit(axis);
    }
    return score > 0 && fitted[0] && fitted[1] || fitSingle();
  }

  /** Fits all events as those of one wing, on either side of the axis. */
  private boolean fitSingle() {
    fittedAxis = spectrum.axisRad;
    split.along(fittedAxis);
    double across = SINGLE_SHARE * split.reach(split.middleX, split.middleY);
    double omega = 2 * Math.PI * spectrum.frequencyHz;
    for (int side = 0; side < 2; side++) {
      double sign = side == 0 ? 1 : -1;
      split.classifyAll(side);
      double startX = split.middleX + sign * across * Math.sin(fittedAxis);
      double startY = split.middleY - sign * across * Math.cos(fittedAxis);
      fitted[side] = lines.search(split, side, startX, startY);
      if (fitted[side]) {
        outerPx = split.reach(lines.x, lines.y);
        fitted[side] =
            fits[side].fit(split, side, fittedAxis, lines.x, lines.y, outerPx, omega, false)
                && isWing(fits[side])
                && fits[side].inliers > SINGLE_INLIERS * fits[side].events;
      }
    }
    if (fitted[0] && fitted[1]) {
      fitted[fits[0].inliers > fits[1].inliers ? 1 : 0] = false;
    }
    return fitted[0] || fitted[1];
  }

  private static boolean isWing(StrokeFit fit) {
    double amplitude = fit.amplitude();
    return fit.inliers > MIN_SHARE * fit.events
        && fit.inliers > 50
        && amplitude > 0.2
        && amplitude < 1.8;
  }

  /** Divides along an axis, fits hinges and strokes; returns the number of explained events. */
  private double fit(double axis) {
    fittedAxis = axis;
    split.along(axis);
    double x = split.middleX;
    double y = split.middleY;
    outerPx = split.reach(x, y);
    for (int pass = 0; pass < 2; pass++) {
      split.classify(x, y, axis);
      for (int side = 0; side < 2; side++) {
        fitted[side] = fitSide(side, pass == 0, x, y);
      }
      if (!fitted[0] && !fitted[1]) {
        return -1;
      }
      if (pass == 0 && fitted[0] && fitted[1]) {
        // a hinge undetermined by the events of one wing follows from the other's
        bodyLine.adjust(fits, axis);
      }
      StrokeFit first = fits[fitted[0] ? 0 : 1];
      StrokeFit second = fits[fitted[1] ? 1 : 0];
      x = (first.hingeX() + second.hingeX()) / 2;
      y = (first.hingeY() + second.hingeY()) / 2;
    }
    if (fitted[0] && fitted[1] && !together()) {
      return -1;
    }
    double inliers = (fitted[0] ? fits[0].inliers : 0) + (fitted[1] ? fits[1].inliers : 0);
    return inliers / Math.max(1, sample.size);
  }

  /** Whether both wings are in phase, as the two halves of one stroke are not. */
  private boolean together() {
    double inPhase = fits[0].cosine(1) * fits[1].cosine(1) + fits[0].sine(1) * fits[1].sine(1);
    return inPhase > MIN_TOGETHER * fits[0].amplitude() * fits[1].amplitude();
  }

  private boolean fitSide(int side, boolean first, double x, double y) {
    double hingeX = fits[side].hingeX();
    double hingeY = fits[side].hingeY();
    if (first || !fitted[side]) {
      if (!lines.search(split, side, x, y)) {
        return false;
      }
      hingeX = lines.x;
      hingeY = lines.y;
    }
    double omega = 2 * Math.PI * spectrum.frequencyHz;
    return fits[side].fit(split, side, fittedAxis, hingeX, hingeY, outerPx, omega, first)
        && isWing(fits[side]);
  }

  /** The fly of the fits; the head by a single wing if there is only one. */
  private FoundFly conclude() {
    double confidence = headTailConfidence();
    StrokeFit first = fits[fitted[0] ? 0 : 1];
    StrokeFit second = fits[fitted[1] ? 1 : 0];
    double turn =
        fitted[0] && fitted[1] && bodyLine.adjust(fits, fittedAxis)
            ? bodyLine.turnRad
            : (first.centre() - second.centre()) / 2;
    boolean flipped = first.asymmetry() + second.asymmetry() < 0;
    StrokeFit left = flipped ? second : first;
    StrokeFit right = flipped ? first : second;
    StrokeSeed[] seeds = new StrokeSeed[2];
    for (int side = 0; side < 2; side++) {
      int found = flipped ? 1 - side : side;
      if (fitted[found]) {
        StrokeSeed seed = fits[found].seed(sample.startUs, flipped);
        seeds[side] = seed.withCentre(seed.centre() + (side == 0 ? -turn : turn));
      }
    }
    FlyGeometry geometry =
        new FlyGeometry(
            (left.hingeX() + right.hingeX()) / 2,
            (left.hingeY() + right.hingeY()) / 2,
            Angles.wrapTwoPi(fittedAxis + turn + (flipped ? Math.PI : 0)),
            outerPx,
            left.hingeX(),
            left.hingeY(),
            right.hingeX(),
            right.hingeY(),
            confidence,
            sample.endUs);
    return new FoundFly(geometry, REGION_SLACK * outerPx, seeds);
  }

  /**
   * Keeps the likelier fits of both hypotheses of the head; returns the confidence.
   *
   * <p>The log-likelihoods of both fits differ by D_g in a part g of the beat and by D in all.
   * Errors of the model repeat from beat to beat, so the events of a part are one sample: D over
   * the root of the sum of D_g² (Vuong, 1989, theorem 5.1, for models none of which need be true;
   * Liang and Zeger, 1986, for samples of many events) is Student's t with (sum of D_g²)² / sum of
   * D_g⁴ degrees of freedom (Satterthwaite, 1946). The confidence is two-sided.
   */
  private double headTailConfidence() {
    double first = fits[fitted[0] ? 0 : 1].asymmetry();
    double second = fits[fitted[1] ? 1 : 0].asymmetry();
    int end = first + second < 0 ? 1 : -1;
    double beyond = 0;
    double all = 0;
    double squares = 0;
    double fourth = 0;
    for (int side = 0; side < 2; side++) {
      if (!fitted[side]) {
        continue;
      }
      double turn = (side == 0 ? first - second : second - first) / 2;
      StrokeFit other = otherEnd[side];
      if (!other.fit(fits[side], end, turn) || !isWing(other)) {
        return 1;
      }
      beyond += end * other.asymmetry();
      for (int part = 0; part < other.losses.length; part++) {
        double square = Math.pow(other.losses[part] - fits[side].losses[part], 2);
        all += other.losses[part] - fits[side].losses[part];
        squares += square;
        fourth += square * square;
      }
    }
    if (all <= 0 && beyond <= StrokeFit.BOUND_SD_RAD) {
      return 0; // the end of these fits is as likely at the bound
    }
    if (all < 0) {
      StrokeFit[] less = fits.clone();
      System.arraycopy(otherEnd, 0, fits, 0, 2);
      System.arraycopy(less, 0, otherEnd, 0, 2);
    }
    TDistribution student = TDistribution.of(squares * squares / fourth);
    return 1 - 2 * student.survivalProbability(Math.abs(all) / Math.sqrt(squares));
  }
}
