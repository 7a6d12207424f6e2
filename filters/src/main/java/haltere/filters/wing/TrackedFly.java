package haltere.filters.wing;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.ArrayList;
import java.util.List;

/**
 * The fly that is tracked: its geometry, and for each wing a frame and the estimators.
 *
 * <p>Thread rule: one thread at a time.
 */
final class TrackedFly {
  private static final WingSide[] SIDES = WingSide.values();

  /** Share of an asymmetry that the heading takes up in one check. */
  private static final double HEADING_SHARE = 0.5;

  private static final double REGION_SLACK = 1.05;

  private final WingListener listener;
  private WingTrackerSettings settings;
  private final StrokeFrame[] frames = {
    new StrokeFrame(WingSide.LEFT), new StrokeFrame(WingSide.RIGHT)
  };
  private final SideEstimator[] main = new SideEstimator[2];
  private final RunningAverage[] beside = new RunningAverage[2];
  private final boolean[] tracked = new boolean[2];
  private final boolean[] takes = new boolean[4];
  private final FlyReport report;
  private final double[] startX = new double[2];
  private final double[] startY = new double[2];
  private final FrequencyAgreement agreement = new FrequencyAgreement();
  private double headingCos;
  private double headingSin;
  private double axisX;
  private double axisY;
  private double symmetry;
  private double followedRad;
  private double confidence;
  private long initialisedAtUs;
  private double sizePx;
  private double regionPx;

  TrackedFly(WingTrackerSettings settings, WingListener listener) {
    this.settings = settings;
    this.listener = listener;
    report = new FlyReport(listener, main, beside, tracked, takes);
    build();
  }

  private void build() {
    for (int side = 0; side < 2; side++) {
      build(side);
    }
    takeEdges();
  }

  private void build(int side) {
    WingFilterSettings filter = settings.filter();
    BeatListener silent = (s, t, period, least, most) -> {};
    beside[side] =
        new RunningAverage(
            SIDES[side],
            frames[side],
            settings.average(),
            filter.method() == WingMethod.WRA ? report::beat : silent);
    main[side] =
        filter.method() == WingMethod.WRA
            ? beside[side]
            : filter.model() == WingModel.EDGES
                ? new EdgesEstimator(SIDES[side], frames[side], settings, report::beat)
                : new WingEstimator(SIDES[side], frames[side], settings, report::beat);
  }

  private void takeEdges() {
    WingOutputSettings output = settings.output();
    takes[0] = output.leftLeading();
    takes[1] = output.leftTrailing();
    takes[2] = output.rightLeading();
    takes[3] = output.rightTrailing();
  }

  boolean isTracked() {
    return tracked[0] || tracked[1];
  }

  int wings() {
    return (tracked[0] ? 1 : 0) + (tracked[1] ? 1 : 0);
  }

  void forget() {
    tracked[0] = false;
    tracked[1] = false;
  }

  double regionPx() {
    return regionPx;
  }

  double meanNis() {
    return !isTracked()
        ? Double.NaN
        : tracked[0] && tracked[1]
            ? (main[0].nis() + main[1].nis()) / 2
            : main[tracked[0] ? 0 : 1].nis();
  }

  double frequencyHz() {
    return !isTracked()
        ? Double.NaN
        : tracked[0] && tracked[1]
            ? (main[0].frequencyHz() + main[1].frequencyHz()) / 2
            : main[tracked[0] ? 0 : 1].frequencyHz();
  }

  /** Frequency of a wing's estimator, hertz; NaN while the wing is not tracked. */
  double frequencyHz(int side) {
    return tracked[side] ? main[side].frequencyHz() : Double.NaN;
  }

  void begin(FoundFly found, long timeUs) {
    FlyGeometry g = found.geometry();
    WingPlaceSettings place = settings.place();
    boolean flip = place.flipHeading();
    double heading = g.headingRad() + (flip ? Math.PI : 0) + place.headingOffsetRad();
    sizePx = g.sizePx();
    confidence = g.headTailConfidence();
    initialisedAtUs = timeUs;
    report.begin();
    agreement.launch();
    regionPx = Math.max(3, sizePx * REGION_SLACK + place.regionOffsetPx());
    for (int side = 0; side < 2; side++) {
      int from = flip ? 1 - side : side;
      startX[side] = from == 0 ? g.leftHingeX() : g.rightHingeX();
      startY[side] = from == 0 ? g.leftHingeY() : g.rightHingeY();
      double x = startX[side] + place.bodyOffsetXPx();
      double y = startY[side] + place.bodyOffsetYPx();
      frames[side].place(x, y, heading, place.innerRadiusPx(), regionPx);
      StrokeSeed seed = found.seeds()[from];
      tracked[side] = seed != null;
      if (seed != null) {
        StrokeSeed turned = flip ? seed.mirrored() : seed;
        launch(
            side,
            timeUs,
            turned.withCentre(turned.centre() - frames[side].turn() * place.headingOffsetRad()));
      }
    }
    symmetry = tracked[0] && tracked[1] ? (main[0].centre() - main[1].centre()) / 2 : 0;
    followedRad = 0;
    placeAxis();
  }

  private void launch(int side, long timeUs, StrokeSeed seed) {
    beside[side].launch(timeUs, seed);
    if (main[side] instanceof WingEstimator wing) {
      int harmonics = settings.filter().harmonics();
      wing.launch(timeUs, seed.state(harmonics, timeUs), StrokeSeed.sd(harmonics));
      wing.frequencyNoise().setRightShare(agreement.share());
    } else if (main[side] instanceof EdgesEstimator edges) {
      double startHz = settings.search().startFrequencyHz();
      if (startHz > 0) {
        edges.launch(timeUs, StrokeSeed.blind(timeUs, seed.centre(), startHz), false);
      } else {
        edges.launch(timeUs, seed, true);
      }
    }
  }

  /** The line that divides left from right: through the middle of the hinges, along the heading. */
  private void placeAxis() {
    double heading = frames[0].headingRad();
    headingCos = Math.cos(heading);
    headingSin = Math.sin(heading);
    axisX = (frames[0].hingeX() + frames[1].hingeX()) / 2;
    axisY = (frames[0].hingeY() + frames[1].hingeY()) / 2;
  }

  void event(long timeUs, int x, int y, boolean on) {
    double across = (y - axisY) * headingCos - (x - axisX) * headingSin;
    int side = across > 0 ? 0 : 1;
    if (!tracked[side] || !takes[on ? 2 * side + 1 : 2 * side] || !frames[side].look(x, y)) {
      return;
    }
    if (main[side].event(timeUs, on) && listener.wantsMeasurements()) {
      report.event(timeUs, side, on, frames[side].angle());
    }
    if (main[side] != beside[side] && settings.filter().method() == WingMethod.BOTH) {
      beside[side].event(timeUs, on);
    }
  }

  void advance(long timeUs) {
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        main[side].advance(timeUs);
        beside[side].advance(timeUs);
      }
    }
  }

  /** Regular work every few milliseconds. */
  void check(long timeUs) {
    for (int side = 0; side < 2; side++) {
      if (tracked[side] && main[side].isLost(timeUs)) {
        tracked[side] = false;
      }
    }
    if (!isTracked()) {
      return;
    }
    if (main[0] instanceof WingEstimator left && main[1] instanceof WingEstimator right) {
      compareFrequencies(left, right);
      if (tracked[0] && tracked[1] && settings.place().followsHeading()) {
        double by = HEADING_SHARE * ((left.centre() - right.centre()) / 2 - symmetry);
        left.turnHeading(by);
        right.turnHeading(by);
        followedRad += by;
      }
    } else if (settings.average().bodyUpdate() && tracked[0] && tracked[1]) {
      followEvents();
    }
    placeAxis();
  }

  private void compareFrequencies(WingEstimator left, WingEstimator right) {
    if (tracked[0]
        && tracked[1]
        && left.frequencyNoise().isCalm()
        && right.frequencyNoise().isCalm()) {
      agreement.compare(
          2 * Math.PI * (left.frequencyHz() - right.frequencyHz()),
          left.frequencyVariance() + right.frequencyVariance());
    }
    left.frequencyNoise().setRightShare(agreement.share());
    right.frequencyNoise().setRightShare(agreement.share());
  }

  /** The running average's way: the body is between the mean places of both wings' events. */
  private void followEvents() {
    double share = settings.average().mixingFactor();
    double middleX = (beside[0].meanX + beside[1].meanX) / 2;
    double middleY = (beside[0].meanY + beside[1].meanY) / 2;
    if (Double.isNaN(middleX + middleY)) {
      return;
    }
    double byX = share * (middleX + settings.place().bodyOffsetXPx() - axisX);
    double byY = share * (middleY + settings.place().bodyOffsetYPx() - axisY);
    double across =
        Math.atan2(beside[0].meanY - beside[1].meanY, beside[0].meanX - beside[1].meanX);
    double turn =
        settings.average().headingUpdate()
            ? share
                * Angles.wrapPi(
                    across
                        - Math.PI / 2
                        + settings.place().headingOffsetRad()
                        - frames[0].headingRad())
            : 0;
    for (StrokeFrame frame : frames) {
      frame.shift(byX, byY);
      frame.setHeading(frame.headingRad() + turn);
    }
  }

  FlyGeometry geometry() {
    return new FlyGeometry(
        (frames[0].hingeX() + frames[1].hingeX()) / 2,
        (frames[0].hingeY() + frames[1].hingeY()) / 2,
        FlyFinder.wrapped(frames[0].headingRad()),
        sizePx,
        frames[0].hingeX(),
        frames[0].hingeY(),
        frames[1].hingeX(),
        frames[1].hingeY(),
        confidence,
        initialisedAtUs);
  }

  void publish(long timeUs, Phase phase) {
    report.tick(timeUs, settings.filter().method() == WingMethod.BOTH);
    if (listener.wantsSnapshots()) {
      report.snapshot(timeUs, phase, geometry(), regionPx);
    }
  }

  /** The Kalman filters of the wings that are tracked. */
  List<WingFilterState> filters() {
    List<WingFilterState> filters = new ArrayList<>();
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        filters.addAll(main[side].filters());
      }
    }
    return filters;
  }

  /** Changes a number of a filter. */
  void edit(WingFilterEdit edit) {
    main[sideOf(edit.part())].edit(edit);
  }

  /** Begins a wing anew where it is now, as sure as when it was found, with the settings' noise. */
  void restart(WingPart part) {
    int side = sideOf(part);
    StrokeSeed seed = main[side].seed();
    build(side);
    launch(side, seed.timeUs(), seed);
  }

  private int sideOf(WingPart part) {
    int side = part.side().ordinal();
    if (!tracked[side] || main[side].filters().stream().noneMatch(f -> f.part() == part)) {
      throw new IllegalArgumentException("there is no filter for " + part + " now");
    }
    return side;
  }

  /** Takes new settings and tracks on. */
  void apply(WingTrackerSettings changed) {
    WingTrackerSettings before = settings;
    settings = changed;
    boolean rebuild =
        changed.filter().method() != before.filter().method()
            || changed.filter().model() != before.filter().model()
            || changed.filter().harmonics() != before.filter().harmonics();
    if (!isTracked()) {
      build();
      return;
    }
    if (!rebuild && changed.place().equals(before.place())) {
      for (int side = 0; side < 2; side++) {
        main[side].apply(changed);
        beside[side].apply(changed);
      }
      takeEdges();
      return;
    }
    StrokeSeed[] seeds = new StrokeSeed[2];
    long timeUs = 0;
    for (int side = 0; side < 2; side++) {
      seeds[side] = tracked[side] ? main[side].seed() : null;
      timeUs = tracked[side] ? seeds[side].timeUs() : timeUs;
    }
    boolean flipped = changed.place().flipHeading() != before.place().flipHeading();
    if (flipped) {
      FlyGeometry g = geometry();
      double heading = frames[0].headingRad() + Math.PI;
      double inner = changed.place().innerRadiusPx();
      frames[0].place(g.rightHingeX(), g.rightHingeY(), heading, inner, regionPx);
      frames[1].place(g.leftHingeX(), g.leftHingeY(), heading, inner, regionPx);
      boolean keep = tracked[0];
      tracked[0] = tracked[1];
      tracked[1] = keep;
      seeds =
          new StrokeSeed[] {
            seeds[1] == null ? null : seeds[1].mirrored(),
            seeds[0] == null ? null : seeds[0].mirrored()
          };
    }
    double byX = changed.place().bodyOffsetXPx() - before.place().bodyOffsetXPx();
    double byY = changed.place().bodyOffsetYPx() - before.place().bodyOffsetYPx();
    double turn =
        Angles.wrapPi(changed.place().headingOffsetRad() - before.place().headingOffsetRad());
    regionPx =
        Math.max(3, regionPx + changed.place().regionOffsetPx() - before.place().regionOffsetPx());
    build();
    for (int side = 0; side < 2; side++) {
      StrokeFrame frame = frames[side];
      frame.place(
          frame.hingeX() + byX,
          frame.hingeY() + byY,
          frame.headingRad() + turn,
          changed.place().innerRadiusPx(),
          regionPx);
      if (tracked[side]) {
        launch(side, timeUs, seeds[side].withCentre(seeds[side].centre() - frame.turn() * turn));
      }
    }
    if (flipped || turn != 0 || rebuild) {
      symmetry = tracked[0] && tracked[1] ? (main[0].centre() - main[1].centre()) / 2 : 0;
    }
    placeAxis();
  }
}
