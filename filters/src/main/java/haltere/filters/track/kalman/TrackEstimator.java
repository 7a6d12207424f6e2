package haltere.filters.track.kalman;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterObserver;
import haltere.filters.cluster.ClusterReadings;
import haltere.filters.cluster.ClusterTracker;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.MeasurementSource;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionNoise;
import java.util.Objects;

/**
 * Kalman filters on the clusters of a {@link ClusterTracker}: each cluster that is seen gets a
 * track, which has its place, velocity and their covariance, in pixels or in metres on a road.
 *
 * <p>J. Cardinale, "Tracking objects and wing beat analysis methods of a fruit fly with the
 * event-based silicon retina", part I, with what {@code docs/tracking.md} says beside it. At
 * regular times of the events (see {@link KalmanTracksSettings#updateIntervalUs}) a track takes the
 * events that its cluster has gathered, if they are enough, as one measurement. Tracks that come
 * near one another go on as predicted until they have parted, and clusters are then given to tracks
 * all together, by {@code Assignment}. A track that loses its cluster coasts, and takes a cluster
 * that appears where it is expected.
 *
 * <p>What it does depends on the events and their times only, not on packets: a report at a time
 * holds what is known of the events before it.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
final class TrackEstimator implements ClusterObserver {
  /**
   * A track near others takes its own cluster without a thought of them up to this normalised
   * innovation squared: 95 % of good measurements are below it.
   */
  private static final double EXPECTED_NIS = 6;

  /** Gated measurements in a row after which a track begins again where its cluster is. */
  private static final int GATED_TILL_RELAUNCH = 3;

  private final SensorGeometry geometry;
  private final TrackListener listener;
  private final ClusterTracker tracker;
  private final Tracks tracks;
  private final EventBatches batches = new EventBatches();
  private final TrackEnds ends;
  private final TrackParts parts;
  private final TrackReports reports;
  private KalmanTracksSettings settings;
  private MeasurementPlane plane;
  private RoadMapping road;
  private TrackPairs pairs;
  private Measurement measurement;

  /** On a road, what follows vehicles there; else null. */
  private RoadVehicles vehicles;

  private boolean started;
  private long lastStepUs;

  /**
   * An estimator that has seen nothing.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   * @param listener hears of updates and reports
   */
  public TrackEstimator(
      SensorGeometry geometry, KalmanTracksSettings settings, TrackListener listener) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.listener = Objects.requireNonNull(listener, "listener");
    this.settings = Objects.requireNonNull(settings, "settings");
    Picture picture = new Picture(geometry);
    tracks = new Tracks(listener);
    parts = new TrackParts(tracks);
    ends = new TrackEnds(picture, tracks, parts);
    reports = new TrackReports(picture, tracks, listener);
    tracker = new ClusterTracker(geometry, unreported(settings), timeUs -> {});
    prepareMotion();
    prepare();
  }

  /**
   * What it does.
   *
   * @return the settings in force
   */
  public KalmanTracksSettings settings() {
    return settings;
  }

  /**
   * Does something else from the next packet on. Tracks go on, unless how they move, or the road,
   * has changed: then they begin anew.
   *
   * @param newSettings the settings to use
   */
  public void apply(KalmanTracksSettings newSettings) {
    boolean same =
        newSettings.motion().equals(settings.motion())
            && newSettings.road().equals(settings.road())
            && newSettings.measurement().equals(settings.measurement())
            && newSettings.life().mostTracks() >= tracks.count();
    settings = Objects.requireNonNull(newSettings, "newSettings");
    tracker.apply(unreported(settings));
    if (!same) {
      tracks.discardAll();
      batches.clear();
      prepareMotion();
    }
    prepare();
  }

  /** Clusters report nothing of their own here. */
  private static ClusterTrackerSettings unreported(KalmanTracksSettings settings) {
    return settings.clusters().with("output.reportRateHz=1", "output.pathPoints=1");
  }

  /** What all tracks share: ones that are there go on with it, also when they are used again. */
  private void prepareMotion() {
    road = settings.road().mapToRoad() ? new RoadMapping(settings.road().view(), geometry) : null;
    plane = new MeasurementPlane(road);
    MotionNoise noise =
        road == null
            ? MotionNoise.inPixels(settings.motion())
            : MotionNoise.onRoad(settings.motion(), settings.road().processVariance());
    tracks.setModel(noise, plane, settings.measurement());
    boolean byLines = road != null && settings.measurement().source() == MeasurementSource.OUTLINE;
    vehicles = byLines ? new RoadVehicles(road, geometry, tracks, plane, listener) : null;
  }

  private void prepare() {
    tracks.setMost(settings.life().mostTracks());
    batches.apply(settings.measurement());
    measurement = new Measurement(settings.measurement(), road != null);
    pairs = new TrackPairs(settings.life());
    parts.apply(settings);
    reports.apply(settings, plane);
    if (vehicles != null) {
      vehicles.apply(settings, pairs.threshold());
    }
    tracker.observe(this, settings.updateIntervalUs());
  }

  /** Forgets all tracks and clusters. Their identities are not given out again. */
  public void reset() {
    tracker.reset();
    tracks.dropAll();
    batches.clear();
    ends.reset();
    parts.reset();
    if (vehicles != null) {
      vehicles.reset();
    }
    started = false;
    reports.reset();
  }

  /**
   * Takes events.
   *
   * @param packet only read
   */
  public void track(EventPacket packet) {
    if (vehicles != null) {
      vehicles.add(packet);
    }
    tracker.track(packet);
  }

  /**
   * The cluster tracker below it.
   *
   * @return to read from; its settings are those of the estimator
   */
  ClusterTracker clusters() {
    return tracker;
  }

  /** The sensor whose events it sees. */
  SensorGeometry geometry() {
    return geometry;
  }

  /** The map to the road, or null. */
  RoadMapping road() {
    return road;
  }

  /**
   * Tracks that are believed and may be shown at the time of a report.
   *
   * @return at least 0; for {@link #shown}
   */
  int trackCount() {
    return tracks.count();
  }

  /** A track if it is to be shown at a time, else null. */
  Track shown(int index, long timeUs) {
    return reports.shown(index, timeUs);
  }

  /** Where the last track of {@link #shown} is in pixels. */
  MeasurementPlane plane() {
    return plane;
  }

  @Override
  public boolean isWaiting(long timeUs) {
    return tracks.count() > 0 || vehicles != null && vehicles.isWaiting(timeUs);
  }

  @Override
  public void clustersMerged(long timeUs, int keptId, int lostId) {
    if (vehicles == null) {
      MergedTracks.merge(batches.find(keptId), batches.find(lostId), tracks);
    }
  }

  @Override
  public void clusterParted(long timeUs, int id) {
    EventBatch batch = batches.find(id);
    if (batch != null) {
      batch.clear(timeUs);
      batch.parted = true;
    }
  }

  @Override
  public void clustersRead(long timeUs, ClusterReadings readings) {
    if (!started || timeUs <= lastStepUs) {
      started = true;
      reports.skipTo(timeUs);
    }
    reports.reportUntil(timeUs - 1, lastStepUs);
    if (vehicles != null) {
      vehicles.step(timeUs);
    } else {
      followClusters(timeUs, readings);
    }
    lastStepUs = timeUs;
    reports.reportUntil(timeUs, lastStepUs);
  }

  private void followClusters(long timeUs, ClusterReadings readings) {
    batches.gather(timeUs, readings);
    for (int i = 0; i < tracks.count(); i++) {
      tracks.get(i).look(timeUs);
    }
    ends.dropThoseThatLeft(timeUs);
    TrackPairs.markContested(tracks, timeUs);
    updateAll(timeUs, readings);
    parts.step(timeUs);
    ends.dropThoseThatEnd(timeUs, settings.life());
    ClusterFeedback.give(tracks, settings, timeUs, readings);
  }

  private void updateAll(long timeUs, ClusterReadings readings) {
    double gate = pairs.threshold();
    pairs.start();
    for (int i = 0; i < batches.count(); i++) {
      EventBatch batch = batches.get(i);
      if (!batches.isDue(batch, timeUs)) {
        continue;
      }
      Track track = batch.track;
      if (track == null) {
        pairs.addBatch(batch);
      } else {
        boolean jumps = batch.parted && !track.nearOther && !track.part.isSwollen();
        track.part.compareSize(batch, track.isSettled() && !batch.parted, timeUs);
        measurement.of(batch, track, readings, timeUs);
        if (jumps && measurement.map(plane)) {
          track.follow(measurement.timeUs, timeUs);
          batch.clear(timeUs);
          continue;
        }
        double nis = track.compare(measurement);
        double expected = track.nearOther ? EXPECTED_NIS : gate;
        if (nis <= expected && !track.contested) {
          take(track, batch, timeUs);
        } else {
          pairs.addBatch(batch);
        }
      }
    }
    if (pairs.batchCount() > 0) {
      assign(timeUs, readings);
    }
    batches.endUpdate();
  }

  private void take(Track track, EventBatch batch, long timeUs) {
    track.take(measurement.timeUs, timeUs);
    track.spreadPx = batch.spreadPx();
    track.part.learn(batch);
    if (track.id == 0
        && track.part.wholeId == 0
        && track.updates >= settings.life().updatesTillShown()) {
      track.id = tracks.nextId();
    }
    batch.clear(timeUs);
    if (track.id > 0) {
      listener.updated(track, measurement, true);
    }
  }

  /** Gives the batches that are in question to the tracks that are, all together. */
  private void assign(long timeUs, ClusterReadings readings) {
    pairs.addTracks(tracks, timeUs);
    pairs.costs(measurement, readings, timeUs);
    pairs.solve();
    for (int j = 0; j < pairs.batchCount(); j++) {
      EventBatch batch = pairs.batch(j);
      Track winner = pairs.winner(j);
      if (winner != null && winner != batch.track) {
        Track loser = batch.track;
        if (loser != null) {
          loser.release(true);
        }
        winner.release(true);
        winner.hold(batch);
      }
    }
    for (int j = 0; j < pairs.batchCount(); j++) {
      EventBatch batch = pairs.batch(j);
      Track winner = pairs.winner(j);
      if (winner != null) {
        measurement.of(batch, winner, readings, timeUs);
        winner.compare(measurement);
        take(winner, batch, timeUs);
      } else if (batch.track != null) {
        refuse(batch, readings, timeUs);
      } else {
        launch(batch, readings, timeUs);
      }
    }
  }

  /** A track whose own cluster is not where it is expected. */
  private void refuse(EventBatch batch, ClusterReadings readings, long timeUs) {
    Track track = batch.track;
    measurement.of(batch, track, readings, timeUs);
    track.gatedInARow++;
    if (track.id > 0) {
      track.compare(measurement);
      listener.updated(track, measurement, false);
    }
    if (road == null && ends.dropIfReplaced(track)) {
      launch(batch, readings, timeUs);
      return;
    }
    batch.clear(timeUs);
    if (track.gatedInARow >= GATED_TILL_RELAUNCH) {
      if (measurement.map(plane)) {
        track.follow(measurement.timeUs, timeUs);
      } else {
        track.release(false);
      }
    }
  }

  private void launch(EventBatch batch, ClusterReadings readings, long timeUs) {
    measurement.of(batch, null, readings, timeUs);
    if (!measurement.map(plane) || ends.isRest(measurement, timeUs)) {
      batch.clear(timeUs);
      return;
    }
    Track again = TrackPairs.unexpectedAt(measurement, tracks, timeUs);
    if (again != null) {
      again.relaunch(measurement.timeUs, timeUs);
      again.hold(batch);
    } else if (!tracks.isFull()) {
      Track track = tracks.add();
      track.launch(measurement.timeUs, timeUs);
      track.spreadPx = batch.spreadPx();
      track.radiusPx = batch.radiusPx;
      track.events = batch.events;
      track.hold(batch);
      parts.begin(track, measurement, batch, timeUs);
      if (track.part.wholeId == 0 && settings.life().updatesTillShown() <= 1) {
        int returning = ends.returning(measurement, timeUs);
        track.id = returning > 0 ? returning : tracks.nextId();
      }
    }
    batch.clear(timeUs);
  }
}
