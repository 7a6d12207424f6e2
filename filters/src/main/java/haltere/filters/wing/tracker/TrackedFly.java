package haltere.filters.wing.tracker;

import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.RunningAverageSettings;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingModel;
import haltere.filters.wing.WingOutputSettings;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingPlaceSettings;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.search.FoundFly;
import haltere.filters.wing.stroke.BeatListener;
import haltere.filters.wing.stroke.EdgesEstimator;
import haltere.filters.wing.stroke.RunningAverage;
import haltere.filters.wing.stroke.SideEstimator;
import haltere.filters.wing.stroke.StrokeFrame;
import haltere.filters.wing.stroke.StrokeSeed;
import haltere.filters.wing.stroke.WingEstimator;
import java.util.ArrayList;
import java.util.List;

/**
 * The fly that is tracked: its geometry, and for each wing a frame and the estimators.
 *
 * <p>Thread rule: one thread at a time.
 */
final class TrackedFly {
  private static final WingSide[] SIDES = WingSide.values();
  private static final int BOTH = 3;

  /** Share of an asymmetry that the heading takes up in one check. */
  private static final double HEADING_SHARE = 0.5;

  private final WingListener listener;
  private WingTrackerSettings settings;
  private final FlyPlace place = new FlyPlace();
  private final StrokeFrame[] frames = place.frames;
  private final SensorGeometry sensor;
  private final SideEstimator[] main = new SideEstimator[2];
  private final RunningAverage[] beside = new RunningAverage[2];
  private final boolean[] tracked = new boolean[2];
  private final boolean[] takes = new boolean[4];

  /** Edges of wings that are tracked, of which events are taken. */
  private final boolean[] takesNow = new boolean[4];

  private final FlyReport report;
  private double symmetry;

  /** Wings of which the running average has ended a beat since the body followed last, as bits. */
  private int beatsEnded;

  /** Angles of pixels while the running average alone is at work, else null. */
  private PixelAngles angles;

  TrackedFly(SensorGeometry sensor, WingTrackerSettings settings, WingListener listener) {
    this.sensor = sensor;
    this.settings = settings;
    this.listener = listener;
    report = new FlyReport(listener, main, beside, tracked, takes);
    build();
  }

  private void build() {
    for (int side = 0; side < 2; side++) {
      build(side);
    }
    boolean averageAlone = settings.filter().method() == WingMethod.WRA;
    angles = averageAlone ? new PixelAngles(sensor.width(), sensor.height(), place) : null;
    takeEdges();
  }

  private void build(int side) {
    WingFilterSettings filter = settings.filter();
    boolean tells = filter.method() == WingMethod.WRA;
    BeatListener beats =
        (s, endUs, periodUs, least, most) -> {
          beatsEnded |= 1 << side;
          if (tells) {
            report.beat(s, endUs, periodUs, least, most);
          }
        };
    beside[side] = new RunningAverage(SIDES[side], frames[side], settings.average(), beats);
    main[side] =
        filter.method() == WingMethod.WRA
            ? beside[side]
            : filter.model() != WingModel.WINGS
                ? new EdgesEstimator(SIDES[side], frames[side], settings, report::beat)
                : new WingEstimator(SIDES[side], frames[side], settings, report::beat);
  }

  private void takeEdges() {
    WingOutputSettings output = settings.output();
    takes[0] = output.leftLeading();
    takes[1] = output.leftTrailing();
    takes[2] = output.rightLeading();
    takes[3] = output.rightTrailing();
    for (int edge = 0; edge < 4; edge++) {
      takesNow[edge] = takes[edge] && tracked[edge / 2];
    }
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
    takeEdges();
  }

  double regionPx() {
    return place.regionPx();
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
    WingPlaceSettings said = settings.place();
    place.begin(found.geometry(), said, timeUs);
    report.begin();
    for (int side = 0; side < 2; side++) {
      StrokeSeed seed = found.seeds()[said.flipHeading() ? 1 - side : side];
      tracked[side] = seed != null;
      if (seed != null) {
        StrokeSeed turned = said.flipHeading() ? seed.mirrored() : seed;
        launch(
            side,
            timeUs,
            turned.withCentre(turned.centre() - frames[side].turn() * said.headingOffsetRad()));
      }
    }
    trackedChanged();
    takeSymmetry();
    forgetAngles();
  }

  /** Edges of wings that are tracked are taken, and two of them are driven together. */
  private void trackedChanged() {
    takeEdges();
    if (main[0] instanceof WingEstimator left && main[1] instanceof WingEstimator right) {
      boolean both = tracked[0] && tracked[1];
      left.besides(both ? right : null);
      right.besides(both ? left : null);
    }
  }

  private void takeSymmetry() {
    symmetry = tracked[0] && tracked[1] ? (main[0].centre() - main[1].centre()) / 2 : 0;
  }

  private void forgetAngles() {
    if (angles != null) {
      angles.clear();
    }
  }

  private void launch(int side, long timeUs, StrokeSeed seed) {
    beside[side].launch(timeUs, seed);
    if (main[side] instanceof WingEstimator wing) {
      wing.launch(timeUs, seed);
    } else if (main[side] instanceof EdgesEstimator edges) {
      double startHz = settings.search().startFrequencyHz();
      if (startHz > 0) {
        edges.launch(timeUs, StrokeSeed.blind(timeUs, seed.centre(), startHz), false);
      } else {
        edges.launch(timeUs, seed, true);
      }
    }
  }

  void event(long timeUs, int x, int y, boolean on) {
    if (angles != null) {
      averageEvent(timeUs, x, y, on);
      return;
    }
    int side = place.side(x, y);
    if (!takesNow[2 * side + (on ? 1 : 0)] || !frames[side].look(x, y)) {
      return;
    }
    if (main[side].event(timeUs, on) && listener.wantsMeasurements()) {
      report.event(timeUs, side, on, frames[side].angle());
    }
    if (settings.filter().method() == WingMethod.BOTH) {
      beside[side].event(timeUs, on);
      if (beatsEnded == BOTH) {
        followBeat();
      }
    }
  }

  private void averageEvent(long timeUs, int x, int y, boolean on) {
    float code = angles.code(x, y);
    int side = PixelAngles.side(code);
    if (code != code || !takesNow[2 * side + (on ? 1 : 0)]) {
      return;
    }
    double angle = PixelAngles.angle(code);
    beside[side].event(timeUs, on, angle, x, y);
    if (listener.wantsMeasurements()) {
      report.event(timeUs, side, on, angle);
    }
    if (beatsEnded == BOTH) {
      followBeat();
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
        trackedChanged();
      }
    }
    if (!isTracked()) {
      return;
    }
    if (main[0] instanceof WingEstimator left && main[1] instanceof WingEstimator right) {
      if (tracked[0] && tracked[1] && settings.place().followsHeading()) {
        double by = HEADING_SHARE * ((left.centre() - right.centre()) / 2 - symmetry);
        left.turnHeading(by);
        right.turnHeading(by);
      }
    }
    place.settle();
  }

  /** Once both wings have ended a beat the body and the heading follow it, where that is wanted. */
  private void followBeat() {
    beatsEnded = 0;
    RunningAverageSettings average = settings.average();
    if ((average.bodyUpdate() || average.headingUpdate())
        && tracked[0]
        && tracked[1]
        && !(main[0] instanceof WingEstimator)) {
      followEvents();
    }
  }

  /** The running average's way: the body is between the mean places of both wings' events. */
  private void followEvents() {
    double share = settings.average().mixingFactor();
    double middleX = (beside[0].meanX() + beside[1].meanX()) / 2;
    double middleY = (beside[0].meanY() + beside[1].meanY()) / 2;
    if (Double.isNaN(middleX + middleY)) {
      return;
    }
    double body = settings.average().bodyUpdate() ? share : 0;
    double byX = body * (middleX + settings.place().bodyOffsetXPx() - place.axisX());
    double byY = body * (middleY + settings.place().bodyOffsetYPx() - place.axisY());
    double across =
        Math.atan2(beside[0].meanY() - beside[1].meanY(), beside[0].meanX() - beside[1].meanX());
    double turn =
        settings.average().headingUpdate()
            ? share
                * Angles.wrapPi(
                    across
                        - Math.PI / 2
                        + settings.place().headingOffsetRad()
                        - frames[0].headingRad())
            : 0;
    place.shift(byX, byY, turn);
    forgetAngles();
  }

  FlyGeometry geometry() {
    return place.geometry();
  }

  void publish(long timeUs, Phase phase) {
    report.tick(timeUs, settings.filter().method() == WingMethod.BOTH);
    if (listener.wantsSnapshots()) {
      report.snapshot(timeUs, phase, geometry(), place.regionPx());
    }
  }

  /** Tells whoever draws that there is nothing to be drawn any more. */
  void publishLoss(long timeUs) {
    if (listener.wantsSnapshots()) {
      report.snapshot(timeUs, Phase.LOST, geometry(), place.regionPx());
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
    trackedChanged();
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
    if (!isTracked()) {
      build();
      return;
    }
    boolean rebuild = !isSameEstimator(before.filter(), changed.filter());
    if (!rebuild) {
      for (int side = 0; side < 2; side++) {
        main[side].apply(changed);
        beside[side].apply(changed);
      }
      takeEdges();
      if (changed.place().equals(before.place())) {
        return;
      }
    }
    StrokeSeed[] seeds = seeds();
    boolean flipped = changed.place().flipHeading() != before.place().flipHeading();
    if (flipped) {
      place.exchange(changed.place().innerRadiusPx());
      boolean keep = tracked[0];
      tracked[0] = tracked[1];
      tracked[1] = keep;
      seeds = new StrokeSeed[] {mirrored(seeds[1]), mirrored(seeds[0])};
    }
    double turn = place.move(before.place(), changed.place());
    if (rebuild || flipped) {
      build();
    }
    forgetAngles();
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        StrokeSeed seed = seeds[side];
        launch(side, seed.timeUs(), seed.withCentre(seed.centre() - frames[side].turn() * turn));
      }
    }
    trackedChanged();
    if (flipped || turn != 0 || rebuild) {
      takeSymmetry();
    }
  }

  private static boolean isSameEstimator(WingFilterSettings one, WingFilterSettings other) {
    return one.method() == other.method()
        && one.model() == other.model()
        && one.harmonics() == other.harmonics();
  }

  private StrokeSeed[] seeds() {
    StrokeSeed[] seeds = new StrokeSeed[2];
    for (int side = 0; side < 2; side++) {
      seeds[side] = tracked[side] ? main[side].seed() : null;
    }
    return seeds;
  }

  private static StrokeSeed mirrored(StrokeSeed seed) {
    return seed == null ? null : seed.mirrored();
  }
}
