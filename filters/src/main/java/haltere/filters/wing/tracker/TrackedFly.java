package haltere.filters.wing.tracker;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventQueues;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPositionSettings;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.internal.search.FoundFly;
import haltere.filters.wing.internal.stroke.StrokeFrame;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import haltere.filters.wing.internal.stroke.WingEstimator;
import java.util.List;
import java.util.Optional;

/**
 * The fly that is tracked: its geometry, and for each wing a frame and the estimators.
 *
 * <p>A running average beside a filter that follows the hinges has its own position, so that its
 * results are those without the filter. In all other cases both methods share one position.
 */
final class TrackedFly {
  /** Share of an asymmetry by which the heading is corrected in one check. */
  private static final double HEADING_SHARE = 0.5;

  private final WingListener listener;
  private WingTrackerSettings settings;
  final FlyPosition position = new FlyPosition();
  private final StrokeFrame[] frames = position.frames;
  private final SensorGeometry sensor;

  final WingEstimators wings;

  /** Whether a Kalman filter and whether a running average are used. */
  private boolean filters;

  private boolean averages;

  /** Whether measurements are wanted. */
  private boolean measures;

  /** Whether events wait until both wings meet. */
  private boolean isQueueing;

  /** Waiting events of each wing. */
  final EventQueues queues = new EventQueues(2, this::take);

  /** Position of the running average. */
  private FlyPosition averagePosition = position;

  /** The last result of the search. */
  private FoundFly fly;

  private long foundAtUs;
  private PixelAngles angles;
  private BodyFollower follower;
  private double symmetry;

  TrackedFly(SensorGeometry sensor, WingTrackerSettings settings, WingListener listener) {
    this.sensor = sensor;
    this.settings = settings;
    this.listener = listener;
    wings = new WingEstimators(frames, listener);
    build();
  }

  private void build() {
    filters = settings.filter().method() != WingMethod.WRA;
    averages = TrackerParts.averages(settings);
    averagePosition = TrackerParts.sharesFrames(settings) ? position : new FlyPosition();
    if (averagePosition != position && fly != null) {
      averagePosition.begin(fly, settings.position(), foundAtUs);
    }
    angles = averages ? new PixelAngles(sensor.width(), sensor.height(), averagePosition) : null;
    follower = new BodyFollower(averagePosition, settings);
    wings.build(settings, follower);
  }

  void begin(FoundFly found, long timeUs) {
    fly = found;
    foundAtUs = timeUs;
    WingPositionSettings offsets = settings.position();
    position.begin(found, offsets, timeUs);
    if (averagePosition != position) {
      averagePosition.begin(found, offsets, timeUs);
    }
    wings.report.begin();
    for (int side = 0; side < 2; side++) {
      StrokeSeed seed = found.seeds()[offsets.flipHeading() ? 1 - side : side];
      wings.tracked[side] = seed != null;
      if (seed != null) {
        StrokeSeed turned = offsets.flipHeading() ? seed.mirrored() : seed;
        wings.launch(
            side,
            timeUs,
            turned.withCentre(turned.centre() - frames[side].turn() * offsets.headingOffsetRad()));
      }
    }
    launched();
    takeSymmetry();
  }

  /** Called after the estimators have restarted. */
  private void launched() {
    wings.trackedChanged();
    follower.launch();
    if (averages) {
      angles.clear();
    }
  }

  private void takeSymmetry() {
    symmetry = wings.tracked[0] && wings.tracked[1] ? asymmetry() : 0;
  }

  /** Half of the difference of the centres. */
  private double asymmetry() {
    return (wings.main[0].seed().centre() - wings.main[1].seed().centre()) / 2;
  }

  /** Starts a packet. */
  void beginPacket() {
    measures = listener.isRequested(WingMeasurement.class);
    // a wing with a filter for each edge reports beats at its events
    isQueueing = !measures && !averages && wings.main[0] instanceof WingEstimator;
  }

  private void take(int side, EventPacket events) {
    for (int i = 0; i < events.size(); i++) {
      if (frames[side].look(events.x(i), events.y(i))) {
        wings.main[side].event(events.timeUs(i), events.isOn(i));
      }
    }
  }

  void event(long timeUs, int address) {
    int x = EventAddress.x(address);
    int y = EventAddress.y(address);
    boolean on = EventAddress.isOn(address);
    if (filters) {
      int side = position.side(x, y);
      boolean takes = wings.takesNow[2 * side + (on ? 1 : 0)];
      if (takes && isQueueing) {
        queues.add(side, timeUs, address);
      } else if (takes && frames[side].look(x, y)) {
        double expected = wings.main[side].event(timeUs, on);
        if (measures) {
          wings.report.event(timeUs, side, on, frames[side].angle(), expected);
        }
      }
    }
    if (averages) {
      averageEvent(timeUs, x, y, on);
    }
  }

  /** A passage of a pixel has ended; takes its resolved time, microseconds. */
  void passed(int address, long resolvedUs) {
    int side = position.side(EventAddress.x(address), EventAddress.y(address));
    if (wings.main[side] instanceof WingEstimator wing) {
      wing.passed(address, resolvedUs);
    }
  }

  private void averageEvent(long timeUs, int x, int y, boolean on) {
    float code = angles.code(x, y);
    int side = PixelAngles.side(code);
    if (code != code || !wings.takesNow[2 * side + (on ? 1 : 0)]) {
      return;
    }
    double angle = PixelAngles.angle(code);
    double expected = wings.beside[side].event(timeUs, on, angle);
    if (!filters && measures) {
      wings.report.event(timeUs, side, on, angle, expected);
    }
    if (follower.event(side, x, y)) {
      angles.clear();
    }
  }

  /** Periodic work, every few milliseconds. */
  void check(long timeUs) {
    boolean[] lost = new boolean[2];
    for (int side = 0; side < 2; side++) {
      lost[side] = wings.tracked[side] && wings.main[side].isLost(timeUs);
    }
    // the original's search does not find a single wing again: its filters wait for it
    if (!TrackerParts.isOriginal(settings) || lost[0] && lost[1]) {
      wings.tracked[0] &= !lost[0];
      wings.tracked[1] &= !lost[1];
    }
    if (lost[0] || lost[1]) {
      wings.trackedChanged();
    }
    if (!wings.isTracked()) {
      return;
    }
    if (wings.main[0] instanceof WingEstimator left
        && wings.main[1] instanceof WingEstimator right) {
      if (wings.tracked[0] && wings.tracked[1] && settings.position().followsHeading()) {
        double by = HEADING_SHARE * (asymmetry() - symmetry);
        left.turnHeading(by);
        right.turnHeading(by);
      }
    }
    position.settle();
  }

  Optional<FlyGeometry> averageGeometry() {
    return averages && averagePosition != position
        ? Optional.of(averagePosition.geometry())
        : Optional.empty();
  }

  void publish(long timeUs, Phase phase) {
    wings.report.tick(timeUs, settings.filter().method() == WingMethod.BOTH);
    publishSnapshot(timeUs, phase);
  }

  /** Publishes a snapshot, also an empty one. */
  void publishSnapshot(long timeUs, Phase phase) {
    if (listener.isRequested(WingSnapshot.class)) {
      wings.report.snapshot(timeUs, phase, position.geometry(), position.regionPx);
    }
  }

  /** Applies new settings without a restart. */
  void apply(WingTrackerSettings changed) {
    WingTrackerSettings before = settings;
    settings = changed;
    boolean rebuild = wings.apply(changed) || TrackerParts.averages(changed) != averages;
    boolean moved = !changed.position().equals(before.position());
    if (!wings.isTracked()) {
      build();
      return;
    }
    follower.apply(changed);
    if (!rebuild && !moved) {
      return;
    }
    StrokeSeed[] seeds = wings.seeds();
    boolean flipped = changed.position().flipHeading() != before.position().flipHeading();
    double turn = 0;
    for (FlyPosition each :
        averagePosition == position ? List.of(position) : List.of(averagePosition, position)) {
      if (flipped) {
        each.exchange(changed.position().innerRadiusPx());
      }
      turn = each.move(before.position(), changed.position());
    }
    if (flipped) {
      wings.exchange();
      seeds = new StrokeSeed[] {mirrored(seeds[1]), mirrored(seeds[0])};
    }
    if (rebuild || flipped) {
      build();
    }
    for (int side = 0; side < 2; side++) {
      if (wings.tracked[side]) {
        StrokeSeed seed = seeds[side];
        wings.launch(
            side, seed.timeUs(), seed.withCentre(seed.centre() - frames[side].turn() * turn));
      }
    }
    launched();
    if (flipped || turn != 0 || rebuild) {
      takeSymmetry();
    }
  }

  private static StrokeSeed mirrored(StrokeSeed seed) {
    return seed == null ? null : seed.mirrored();
  }
}
