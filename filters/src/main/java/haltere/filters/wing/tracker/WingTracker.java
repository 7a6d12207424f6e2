package haltere.filters.wing.tracker;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.ReportClock;
import haltere.core.stream.SharedWork;
import haltere.filters.estimation.Angles;
import haltere.filters.noise.internal.PolarityRuns;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.ManualWingChange;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.internal.search.FlySearch;
import haltere.filters.wing.internal.search.FoundFly;
import haltere.filters.wing.internal.search.FrequencyWatch;
import haltere.filters.wing.internal.search.RecentEvents;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Tracks the wings of a tethered fly: gathers events, finds the fly in them ({@link FlySearch}),
 * tracks the wings with the method of the settings, and searches again after a loss.
 *
 * <p>Results do not depend on the packets. Thread rule: one thread at a time.
 */
public final class WingTracker {
  private static final int CHECK_US = 10_000;

  /** Interval at which both wings are synchronised, independent of the rate of the estimates. */
  private static final int SYNC_US = 1000;

  /** Outcomes of a search; the other phases are its steps. */
  private static final Set<Phase> CONDITIONS =
      EnumSet.of(Phase.COLLECTING, Phase.TRACKING, Phase.UNLOCKED, Phase.ONE_WING, Phase.LOST);

  /** Next due time while no fly is tracked: every event. */
  private static final long AT_ONCE = Long.MIN_VALUE;

  private final WingListener listener;
  private final SensorGeometry sensor;
  private FlySearch search;
  private final RecentEvents recent = new RecentEvents();
  private final TrackedFly fly;
  private final FrequencyWatch watch = new FrequencyWatch();

  /** Steps and outcome of the last search. */
  private final Map<Phase, WingTrackerState> steps = new EnumMap<>(Phase.class);

  private final ReportClock ticks = new ReportClock();
  private final PolarityRuns runs;
  private WingTrackerSettings settings;
  private Phase phase = Phase.COLLECTING;
  private boolean begun;
  private long dueUs;
  private long nextCheckUs;
  private long publishedUs;

  /**
   * A tracker in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the tracker
   * @param listener receives the results
   */
  public WingTracker(SensorGeometry geometry, WingTrackerSettings settings, WingListener listener) {
    this.settings = settings;
    this.listener = listener;
    sensor = geometry;
    search = TrackerParts.search(settings, geometry, recent, this::publish);
    fly = new TrackedFly(geometry, settings, listener);
    runs = new PolarityRuns(geometry);
    ticks.setRate(settings.output().rateHz());
    reset();
  }

  void share(SharedWork work) {
    fly.queues.share(work);
  }

  /** Returns to the initial state; settings, with manual positions, stay. */
  public void reset() {
    recent.clear();
    runs.clear();
    phase = Phase.COLLECTING;
    begun = false;
    dueUs = AT_ONCE;
    steps.clear();
    fly.wings.forget();
  }

  /** {@return the settings in force} */
  public WingTrackerSettings settings() {
    return settings;
  }

  /**
   * Applies new settings; tracking continues.
   *
   * @param changed valid settings
   */
  public void apply(WingTrackerSettings changed) {
    if (TrackerParts.isOriginal(changed) != TrackerParts.isOriginal(settings)) {
      search = TrackerParts.search(changed, sensor, recent, this::publish);
      search.startAt(publishedUs);
    }
    settings = changed;
    fly.apply(changed);
    ticks.setRate(changed.output().rateHz());
    if (fly.wings.isTracked()) {
      long lastUs = Math.max(publishedUs, recent.timeUs(recent.size() - 1));
      ticks.skipTo(lastUs + 1);
      dueUs = dueAfter(lastUs);
    }
  }

  /** {@return the present phase of the tracker} */
  public Phase phase() {
    return phase;
  }

  /**
   * {@return the steps of the last search and, as the last one, its outcome; empty before the first
   * event}
   */
  public List<WingTrackerState> searchSteps() {
    return List.copyOf(steps.values());
  }

  /**
   * {@return the recent mean normalised innovation squared of the Kalman filters: 1 if they are
   * consistent, NaN while no wing is tracked by a filter that has one}
   */
  public double meanNis() {
    return fly.wings.meanNis();
  }

  /**
   * {@return the present Kalman filters: one for each tracked wing, or for each of its edges; none
   * with the running average}
   */
  public List<WingFilterState> filters() {
    return fly.wings.filters();
  }

  /**
   * Changes a number of a filter while it runs. Changed noise remains until the filter is {@link
   * #restart restarted}, the settings of the noise change, or head and tail are exchanged.
   *
   * @param edit the change
   * @throws IllegalArgumentException with a message for users if the value is not possible, or
   *     there is no such filter now
   */
  public void edit(WingFilterEdit edit) {
    fly.wings.edit(edit);
    listener.accept(new ManualWingChange(edit.part(), Optional.of(edit)));
  }

  /**
   * Restarts a filter at its present state with the initial covariance and the noise of the
   * settings. With a filter for each edge, this restarts both edges of the wing.
   *
   * @param part the wing, or one of its edges
   * @throws IllegalArgumentException with a message for users if there is no such filter now
   */
  public void restart(WingPart part) {
    fly.wings.restart(part);
    listener.accept(new ManualWingChange(part, Optional.empty()));
  }

  /** {@return the geometry of the fly; empty while none is tracked} */
  public Optional<FlyGeometry> geometry() {
    return fly.wings.isTracked() ? Optional.of(fly.position.geometry()) : Optional.empty();
  }

  /**
   * {@return the geometry of the fly for a running average with its own body, beside a filter that
   * follows the hinges; empty while no fly is tracked or both methods share the body}
   */
  public Optional<FlyGeometry> averageGeometry() {
    return fly.wings.isTracked() ? fly.averageGeometry() : Optional.empty();
  }

  /** {@return the radius of the region of interest about each hinge, pixels, of a tracked fly} */
  public double regionPx() {
    return fly.position.regionPx;
  }

  /**
   * Settings with a manual position of the body, as an offset from the found one.
   *
   * @param x column
   * @param y row
   * @return the present settings with other offsets; the same while no fly is tracked
   */
  public WingTrackerSettings withBodyAt(double x, double y) {
    if (!fly.wings.isTracked()) {
      return settings;
    }
    FlyGeometry now = fly.position.geometry();
    return settings.with(
        "position.bodyOffsetXPx=" + (settings.position().bodyOffsetXPx() + x - now.centreX()),
        "position.bodyOffsetYPx=" + (settings.position().bodyOffsetYPx() + y - now.centreY()));
  }

  /**
   * Settings with a manual heading, as an offset from the found one.
   *
   * @param headingRad from tail to head
   * @return the present settings with another offset; the same while no fly is tracked
   */
  public WingTrackerSettings withHeading(double headingRad) {
    if (!fly.wings.isTracked()) {
      return settings;
    }
    double offset =
        Angles.wrapPi(
            settings.position().headingOffsetRad()
                + headingRad
                - fly.position.geometry().headingRad());
    return settings.with("position.headingOffsetRad=" + offset);
  }

  /** {@return the present settings with head and tail exchanged} */
  public WingTrackerSettings withHeadingFlipped() {
    return settings.with("position.flipHeading=" + !settings.position().flipHeading());
  }

  /**
   * Settings with a manual region of interest.
   *
   * @param radiusPx about each hinge
   * @return the present settings with another offset; the same while no fly is tracked
   */
  public WingTrackerSettings withRegion(double radiusPx) {
    if (!fly.wings.isTracked()) {
      return settings;
    }
    return settings.with(
        "position.regionOffsetPx="
            + (settings.position().regionOffsetPx() + radiusPx - fly.position.regionPx));
  }

  /**
   * Processes a packet, which is not changed.
   *
   * @param packet in order of time
   */
  public void track(EventPacket packet) {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    fly.beginPacket();
    boolean firstOfRun = settings.filter().firstOfRun();
    for (int i = 0; i < size; i++) {
      long timeUs = times[i];
      int address = addresses[i];
      recent.add(timeUs, address);
      if (timeUs >= dueUs && !work(timeUs)) {
        continue;
      }
      if (!firstOfRun || runs.begins(timeUs, address)) {
        fly.event(timeUs, address);
        if (firstOfRun && runs.hasPassed()) {
          fly.passed(address, runs.resolvedUs());
        }
      }
    }
    fly.queues.process();
  }

  /** Does the work due at a time; false if its event is not tracked. */
  private boolean work(long timeUs) {
    if (!fly.wings.isTracked()) {
      searchFly(timeUs);
      return false;
    }
    passTicks(timeUs);
    if (!fly.wings.isTracked()) {
      dueUs = AT_ONCE;
    }
    return fly.wings.isTracked();
  }

  private void searchFly(long timeUs) {
    if (!begun) {
      begun = true;
      search.begin(timeUs, settings.search());
      publish(timeUs, Phase.COLLECTING, 0);
    }
    begin(search.look(timeUs, settings.search()), timeUs);
  }

  private void begin(FoundFly found, long timeUs) {
    if (found == null) {
      return;
    }
    if (!fly.wings.isTracked()) {
      publishedUs = timeUs;
      ticks.skipTo(timeUs + 1);
    }
    fly.begin(found, timeUs);
    // a search without the beat leaves it to the filters
    fly.wings.locked = !TrackerParts.isOriginal(settings);
    nextCheckUs = -Math.floorDiv(-(timeUs + CHECK_US), SYNC_US) * SYNC_US;
    dueUs = dueAfter(timeUs);
    watch.launch();
    setPhase(timeUs);
    listener.accept(fly.position.geometry());
  }

  private void setPhase(long timeUs) {
    Phase now =
        !fly.wings.isTracked()
            ? Phase.LOST
            : !fly.wings.locked
                ? Phase.UNLOCKED
                : fly.wings.count() == 2 ? Phase.TRACKING : Phase.ONE_WING;
    if (now != phase) {
      phase = now;
      publish(timeUs, now, recent.size());
      if (now == Phase.LOST) {
        fly.publishSnapshot(timeUs, now);
      }
      search.startAt(timeUs + CHECK_US);
    }
  }

  private void publish(long timeUs, Phase now, int events) {
    FlyGeometry g = fly.wings.isTracked() ? fly.position.geometry() : null;
    double confidence = g == null ? Double.NaN : g.headTailConfidence();
    publish(WingTrackerState.of(timeUs, now, events, fly.wings.frequencyHz(), g, confidence));
  }

  private void publish(WingTrackerState state) {
    if (state.phase() == Phase.TWO_MEANS) {
      steps.keySet().retainAll(CONDITIONS);
    } else if (CONDITIONS.contains(state.phase())) {
      steps.keySet().removeAll(CONDITIONS);
    }
    steps.put(state.phase(), state);
    listener.accept(state);
  }

  /** Makes due checks and estimates; checks do not wait for estimates, whose rate may be low. */
  private void passTicks(long timeUs) {
    while (dueUs <= timeUs) {
      long now = dueUs;
      fly.queues.process();
      fly.wings.advance(now);
      if (now >= nextCheckUs) {
        check(now);
        if (!fly.wings.isTracked()) {
          return;
        }
      }
      if (now >= ticks.nextUs()) {
        fly.publish(now, phase);
        publishedUs = now;
        ticks.advance();
      }
      dueUs = dueAfter(now);
    }
  }

  private long dueAfter(long timeUs) {
    return Math.min(ticks.nextUs(), (Math.floorDiv(timeUs, SYNC_US) + 1) * SYNC_US);
  }

  /** Periodic work: heading, detection of a lost wing, and its search. */
  private void check(long timeUs) {
    nextCheckUs = timeUs + CHECK_US;
    fly.check(timeUs);
    WingEstimators wings = fly.wings;
    if (wings.isTracked()) {
      watch.look(
          recent,
          timeUs,
          fly.position.geometry(),
          settings.search(),
          wings.frequencyHz(0),
          wings.frequencyHz(1));
      if (TrackerParts.isOriginal(settings)) {
        wings.locked = wings.locked ? !watch.isWrong() : watch.isRight();
      } else if (watch.isWrong()) {
        wings.forget();
        setPhase(timeUs);
        search.startAt(timeUs);
        return;
      }
    }
    setPhase(timeUs);
    if (wings.count() == 1
        && settings.output().uses(WingPart.LEFT)
        && settings.output().uses(WingPart.RIGHT)) {
      begin(search.findBoth(timeUs, settings.search()), timeUs);
    }
  }
}
