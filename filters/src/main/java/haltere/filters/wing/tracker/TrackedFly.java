package haltere.filters.wing.tracker;

import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.RunningAverageSettings;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPlaceSettings;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.search.FoundFly;
import haltere.filters.wing.stroke.RunningAverage;
import haltere.filters.wing.stroke.SideEstimator;
import haltere.filters.wing.stroke.StrokeFrame;
import haltere.filters.wing.stroke.StrokeSeed;
import haltere.filters.wing.stroke.WingEstimator;

/**
 * The fly that is tracked: its geometry, and for each wing a frame and the estimators.
 *
 * <p>Thread rule: one thread at a time.
 */
final class TrackedFly {
  /** Share of an asymmetry that the heading takes up in one check. */
  private static final double HEADING_SHARE = 0.5;

  private final WingListener listener;
  private WingTrackerSettings settings;
  private final FlyPlace place = new FlyPlace();
  private final StrokeFrame[] frames = place.frames;
  private final SensorGeometry sensor;
  private final WingEstimators wings;
  private final SideEstimator[] main;
  private final RunningAverage[] beside;
  private final boolean[] tracked;
  private final boolean[] takesNow;
  private double symmetry;

  /** Angles of pixels while the running average alone is at work, else null. */
  private PixelAngles angles;

  TrackedFly(SensorGeometry sensor, WingTrackerSettings settings, WingListener listener) {
    this.sensor = sensor;
    this.settings = settings;
    this.listener = listener;
    wings = new WingEstimators(frames, settings, listener);
    main = wings.main;
    beside = wings.beside;
    tracked = wings.tracked;
    takesNow = wings.takesNow;
    build();
  }

  private void build() {
    wings.build();
    boolean averageAlone = settings.filter().method() == WingMethod.WRA;
    angles = averageAlone ? new PixelAngles(sensor.width(), sensor.height(), place) : null;
  }

  /** What estimates the strokes. */
  WingEstimators wings() {
    return wings;
  }

  double regionPx() {
    return place.regionPx();
  }

  void begin(FoundFly found, long timeUs) {
    WingPlaceSettings said = settings.place();
    place.begin(found.geometry(), said, timeUs);
    wings.report.begin();
    for (int side = 0; side < 2; side++) {
      StrokeSeed seed = found.seeds()[said.flipHeading() ? 1 - side : side];
      tracked[side] = seed != null;
      if (seed != null) {
        StrokeSeed turned = said.flipHeading() ? seed.mirrored() : seed;
        wings.launch(
            side,
            timeUs,
            turned.withCentre(turned.centre() - frames[side].turn() * said.headingOffsetRad()));
      }
    }
    wings.trackedChanged();
    takeSymmetry();
    forgetAngles();
  }

  private void takeSymmetry() {
    symmetry = tracked[0] && tracked[1] ? (main[0].centre() - main[1].centre()) / 2 : 0;
  }

  private void forgetAngles() {
    if (angles != null) {
      angles.clear();
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
      wings.report.event(timeUs, side, on, frames[side].angle());
    }
    if (settings.filter().method() == WingMethod.BOTH) {
      beside[side].event(timeUs, on);
      if (wings.beatOfBoth()) {
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
      wings.report.event(timeUs, side, on, angle);
    }
    if (wings.beatOfBoth()) {
      followBeat();
    }
  }

  /** Regular work every few milliseconds. */
  void check(long timeUs) {
    for (int side = 0; side < 2; side++) {
      if (tracked[side] && main[side].isLost(timeUs)) {
        tracked[side] = false;
        wings.trackedChanged();
      }
    }
    if (!wings.isTracked()) {
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
    wings.report.tick(timeUs, settings.filter().method() == WingMethod.BOTH);
    if (listener.wantsSnapshots()) {
      wings.report.snapshot(timeUs, phase, geometry(), place.regionPx());
    }
  }

  /** Tells whoever draws that there is nothing to be drawn any more. */
  void publishLoss(long timeUs) {
    if (listener.wantsSnapshots()) {
      wings.report.snapshot(timeUs, Phase.LOST, geometry(), place.regionPx());
    }
  }

  /** Takes new settings and tracks on. */
  void apply(WingTrackerSettings changed) {
    WingTrackerSettings before = settings;
    settings = changed;
    if (!wings.isTracked()) {
      wings.applyToNew(changed);
      build();
      return;
    }
    boolean rebuild = wings.apply(changed);
    if (!rebuild && changed.place().equals(before.place())) {
      return;
    }
    StrokeSeed[] seeds = wings.seeds();
    boolean flipped = changed.place().flipHeading() != before.place().flipHeading();
    if (flipped) {
      place.exchange(changed.place().innerRadiusPx());
      wings.exchange();
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
        wings.launch(
            side, seed.timeUs(), seed.withCentre(seed.centre() - frames[side].turn() * turn));
      }
    }
    wings.trackedChanged();
    if (flipped || turn != 0 || rebuild) {
      takeSymmetry();
    }
  }

  private static StrokeSeed mirrored(StrokeSeed seed) {
    return seed == null ? null : seed.mirrored();
  }
}
