package haltere.filters.track;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterObserver;
import haltere.filters.cluster.ClusterReadings;
import haltere.filters.cluster.ClusterTracker;
import haltere.filters.cluster.ClusterTrackerSettings;
import java.util.Arrays;
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
 * all together, by {@link Assignment}. A track that loses its cluster coasts, and takes a cluster
 * that appears where it is expected.
 *
 * <p>What it does depends on the events and their times only, not on packets: a report at a time
 * holds what is known of the events before it.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class TrackEstimator implements ClusterObserver {
  private static final double US = 1e-6;

  /** A report goes on for so long after the last measurement of a track that is not hidden. */
  private static final long SHOWN_WITHOUT_CLUSTER_US = 100_000;

  /**
   * A track is shown when its place is known this well, in standard deviations of its events: a
   * launch of two good measurements is, what gathers events of noise is not.
   */
  private static final double SURE_SPREADS = 0.5;

  /** Nearer to the border than this, what loses its cluster is taken to have left. */
  private static final double LEAVING_SPREADS = 1.3;

  /** A cluster that gets too few events for so long gives what it has. */
  private static final long LONGEST_BATCH_US = 50_000;

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
  private final ReportClock clock = new ReportClock();
  private KalmanTracksSettings settings;
  private MotionNoise noise;
  private MeasurementPlane plane;
  private RoadMapping road;
  private TrackPairs pairs;
  private Measurement measurement;

  private Track[] tracks = new Track[0];
  private int count;
  private EventBatch[] batches = new EventBatch[0];
  private int batchCount;
  private int lastId;
  private boolean started;
  private long lastStepUs;
  private double eventsOfAll;
  private boolean showed;

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
            && newSettings.life().mostTracks() >= count;
    settings = Objects.requireNonNull(newSettings, "newSettings");
    tracker.apply(unreported(settings));
    if (!same) {
      dropAll();
      tracks = new Track[0];
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
    noise =
        road == null
            ? MotionNoise.inPixels(settings.motion())
            : MotionNoise.onRoad(settings.motion(), settings.road().processVariance());
  }

  private void prepare() {
    tracks = Arrays.copyOf(tracks, settings.life().mostTracks());
    measurement = new Measurement(settings.measurement());
    pairs = new TrackPairs(settings.life());
    clock.setRate(settings.life().reportRateHz());
    tracker.observe(this, settings.updateIntervalUs());
  }

  /** Forgets all tracks and clusters. Their identities are not given out again. */
  public void reset() {
    tracker.reset();
    dropAll();
    started = false;
    showed = false;
  }

  private void dropAll() {
    while (count > 0) {
      drop(count - 1);
    }
    batchCount = 0;
    eventsOfAll = 0;
  }

  /**
   * Takes events.
   *
   * @param packet only read
   */
  public void track(EventPacket packet) {
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
    return count;
  }

  /** A track if it is to be shown at a time, else null. */
  Track shown(int index, long timeUs) {
    Track track = tracks[index];
    if (track.id == 0) {
      return null;
    }
    if (track.batch == null && !track.hidden && timeUs - track.heardUs > SHOWN_WITHOUT_CLUSTER_US) {
      return null;
    }
    return plane.toPixels(track.at(timeUs))
            && isInPicture(plane.xPx, plane.yPx, 0.5)
            && isSure(track)
        ? track
        : null;
  }

  /** Whether it is known where a track is, by far better than by one of its events. */
  private boolean isSure(Track track) {
    double most = SURE_SPREADS * track.spreadPx;
    return track.hidden
        || track.contested
        || settings.measurement().source() == MeasurementSource.CENTRE
        || plane.varianceXPx2 + plane.varianceYPx2 < 2 * most * most;
  }

  /** Where the last track of {@link #shown} is in pixels. */
  MeasurementPlane plane() {
    return plane;
  }

  private boolean isInPicture(double xPx, double yPx, double border) {
    return xPx > -border
        && yPx > -border
        && xPx < geometry.width() - 1 + border
        && yPx < geometry.height() - 1 + border;
  }

  @Override
  public boolean isWaiting() {
    return count > 0;
  }

  @Override
  public void clustersMerged(long timeUs, int keptId, int lostId) {
    EventBatch kept = find(keptId);
    EventBatch lost = find(lostId);
    if (lost == null || lost.track == null) {
      return;
    }
    Track track = lost.track;
    if (kept == null || kept.track == null) {
      release(track, false);
      if (kept != null) {
        bind(track, kept);
      }
      return;
    }
    if (track.id > 0 && kept.track.id > 0 && track.movesUnlike(kept.track)) {
      release(track, true);
      return;
    }
    boolean older = track.id > 0 && (kept.track.id == 0 || track.bornUs < kept.track.bornUs);
    if (older) {
      Track younger = kept.track;
      release(younger, false);
      drop(indexOf(younger));
      release(track, false);
      bind(track, kept);
    } else {
      release(track, false);
      drop(indexOf(track));
    }
  }

  @Override
  public void clustersRead(long timeUs, ClusterReadings readings) {
    if (!started || timeUs <= lastStepUs) {
      started = true;
      clock.skipTo(timeUs);
    }
    reportUntil(timeUs - 1);
    gather(timeUs, readings);
    for (int i = 0; i < count; i++) {
      tracks[i].look(timeUs);
    }
    dropThoseThatLeft();
    pairs.markContested(tracks, count);
    updateAll(timeUs, readings);
    endTracks(timeUs);
    feedBack(timeUs, readings);
    lastStepUs = timeUs;
    reportUntil(timeUs);
  }

  private void reportUntil(long timeUs) {
    while (clock.nextUs() <= timeUs) {
      if (count == 0 && !showed) {
        clock.skipTo(timeUs + 1);
        return;
      }
      long reportUs = clock.nextUs();
      clock.advance();
      boolean shows = false;
      for (int i = 0; i < count && !shows; i++) {
        shows = shown(i, reportUs) != null;
      }
      if (shows || showed) {
        listener.reported(reportUs);
      } else if (reportUs - lastStepUs > 1_000_000) {
        clock.skipTo(timeUs + 1);
      }
      showed = shows;
    }
  }

  private void gather(long timeUs, ClusterReadings readings) {
    for (int i = 0; i < batchCount; i++) {
      batches[i].seen = false;
    }
    int readingCount = readings.count();
    for (int i = 0; i < readingCount; i++) {
      EventBatch batch =
          i < batchCount && batches[i].clusterId == readings.id(i) ? batches[i] : null;
      batch = batch == null ? find(readings.id(i)) : batch;
      batch = batch == null ? begin(readings.id(i), timeUs) : batch;
      batch.add(timeUs, readings, i);
      eventsOfAll += readings.newEvents(i);
      if (batch.track != null) {
        batch.track.events += readings.newEvents(i);
        batch.track.radiusPx = batch.radiusPx;
      }
    }
    for (int i = batchCount - 1; i >= 0; i--) {
      if (!batches[i].seen) {
        EventBatch gone = batches[i];
        if (gone.track != null) {
          release(gone.track, gone.track.contested);
        }
        System.arraycopy(batches, i + 1, batches, i, batchCount - i - 1);
        batches[--batchCount] = gone;
      }
    }
  }

  private EventBatch find(int clusterId) {
    for (int i = 0; i < batchCount; i++) {
      if (batches[i].clusterId == clusterId) {
        return batches[i];
      }
    }
    return null;
  }

  private EventBatch begin(int clusterId, long timeUs) {
    if (batchCount == batches.length) {
      batches = Arrays.copyOf(batches, batchCount + 16);
      for (int i = batchCount; i < batches.length; i++) {
        batches[i] = new EventBatch();
      }
    }
    EventBatch batch = batches[batchCount++];
    batch.begin(clusterId, timeUs);
    return batch;
  }

  private static void bind(Track track, EventBatch batch) {
    track.batch = batch;
    track.hidden = false;
    batch.track = track;
  }

  private static void release(Track track, boolean hidden) {
    if (track.batch != null) {
      track.batch.track = null;
      track.batch = null;
      track.hidden = hidden;
      track.lostXPx = track.nowXPx;
      track.lostYPx = track.nowYPx;
    }
  }

  private boolean isDue(EventBatch batch, long timeUs) {
    if (!(batch.events > 0)) {
      return false;
    }
    int wanted = settings.measurement().eventsTillTrack();
    if (settings.measurement().eventsOf() == EventCount.ALL_CLUSTERS) {
      return eventsOfAll >= wanted;
    }
    return batch.events >= wanted
        || batch.track != null && timeUs - batch.sinceUs >= LONGEST_BATCH_US;
  }

  private void updateAll(long timeUs, ClusterReadings readings) {
    double gate = pairs.threshold();
    pairs.start();
    boolean all = eventsOfAll >= settings.measurement().eventsTillTrack();
    for (int i = 0; i < batchCount; i++) {
      EventBatch batch = batches[i];
      if (!isDue(batch, timeUs)) {
        continue;
      }
      Track track = batch.track;
      if (track == null) {
        pairs.addBatch(batch);
      } else {
        measurement.of(batch, track, readings, timeUs);
        double nis = compare(track);
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
    if (all) {
      eventsOfAll = 0;
    }
  }

  private double compare(Track track) {
    return track.compare(
        measurement.timeUs,
        measurement.x,
        measurement.y,
        measurement.xx,
        measurement.xy,
        measurement.yy);
  }

  private void take(Track track, EventBatch batch, long timeUs) {
    track.take(measurement.timeUs, timeUs);
    track.spreadPx = batch.spreadPx();
    if (track.id == 0 && track.updates >= settings.life().updatesTillShown()) {
      track.id = ++lastId;
    }
    batch.clear(timeUs);
    if (track.id > 0) {
      listener.updated(track, measurement, true);
    }
  }

  /** Gives the batches that are in question to the tracks that are, all together. */
  private void assign(long timeUs, ClusterReadings readings) {
    for (int i = 0; i < count; i++) {
      Track track = tracks[i];
      if (track.batch == null || pairs.contains(track.batch)) {
        pairs.addTrack(track);
      }
    }
    pairs.costs(measurement, readings, timeUs);
    pairs.solve();
    for (int j = 0; j < pairs.batchCount(); j++) {
      EventBatch batch = pairs.batch(j);
      Track winner = pairs.winner(j);
      if (winner != null && winner != batch.track) {
        Track loser = batch.track;
        if (loser != null) {
          release(loser, true);
        }
        release(winner, true);
        bind(winner, batch);
      }
    }
    for (int j = 0; j < pairs.batchCount(); j++) {
      EventBatch batch = pairs.batch(j);
      Track winner = pairs.winner(j);
      if (winner != null) {
        measurement.of(batch, winner, readings, timeUs);
        compare(winner);
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
      compare(track);
      listener.updated(track, measurement, false);
    }
    batch.clear(timeUs);
    if (track.gatedInARow >= GATED_TILL_RELAUNCH) {
      if (measurement.map(plane)) {
        track.relaunch(measurement.timeUs, timeUs);
      } else {
        release(track, false);
      }
    }
  }

  private void launch(EventBatch batch, ClusterReadings readings, long timeUs) {
    measurement.of(batch, null, readings, timeUs);
    if (!measurement.map(plane)) {
      batch.clear(timeUs);
      return;
    }
    Track again = pairs.unexpectedAt(measurement, tracks, count, timeUs);
    if (again != null) {
      again.relaunch(measurement.timeUs, timeUs);
      bind(again, batch);
    } else if (count < tracks.length) {
      Track track = tracks[count];
      if (track == null) {
        track = new Track(noise, plane, settings.measurement());
        tracks[count] = track;
      }
      count++;
      track.launch(measurement.timeUs, timeUs);
      track.spreadPx = batch.spreadPx();
      track.radiusPx = batch.radiusPx;
      track.events = batch.events;
      bind(track, batch);
      if (settings.life().updatesTillShown() <= 1) {
        track.id = ++lastId;
      }
    }
    batch.clear(timeUs);
  }

  /** What has left takes no cluster of what is at the border after it. */
  private void dropThoseThatLeft() {
    for (int i = count - 1; i >= 0; i--) {
      if (tracks[i].batch == null && isLeaving(tracks[i])) {
        drop(i);
      }
    }
  }

  private void endTracks(long timeUs) {
    for (int i = count - 1; i >= 0; i--) {
      Track track = tracks[i];
      track.look(timeUs);
      if (track.batch != null) {
        if (!track.inView) {
          release(track, false);
          drop(i);
        }
        continue;
      }
      double silentS = (timeUs - track.heardUs) * US;
      boolean coasts = track.inView && !isLeaving(track) && silentS <= settings.life().coastTimeS();
      boolean rests = pairs.mayRest(track) && silentS <= settings.life().restTimeS();
      if (track.id == 0 || !coasts && !rests) {
        drop(i);
      }
    }
  }

  /** Whether a track without a cluster is at the border of the picture or beyond it. */
  private boolean isLeaving(Track track) {
    double border = Math.min(LEAVING_SPREADS * track.spreadPx, geometry.longerSide() * 0.1);
    return !isInPicture(track.nowXPx, track.nowYPx, -border);
  }

  private int indexOf(Track track) {
    int index = 0;
    while (tracks[index] != track) {
      index++;
    }
    return index;
  }

  private void drop(int index) {
    Track gone = tracks[index];
    release(gone, false);
    System.arraycopy(tracks, index + 1, tracks, index, count - index - 1);
    tracks[--count] = gone;
    if (gone.id > 0) {
      listener.ended(gone.id);
    }
  }

  /**
   * Says to the clusters what tracks know better: which may not merge, which must not die now, and,
   * if it is asked for, where each is.
   */
  private void feedBack(long timeUs, ClusterReadings readings) {
    boolean always = settings.life().feedbackToCluster();
    for (int i = 0; i < count; i++) {
      Track track = tracks[i];
      if (!track.hasSeenCluster()) {
        continue;
      }
      int index = track.batch.index;
      boolean heard = timeUs - track.heardUs <= LONGEST_BATCH_US && track.gatedInARow == 0;
      if (always && heard) {
        readings.feedBack(index, track.nowXPx, track.nowYPx, track.nowVxPxS, track.nowVyPxS);
      }
      for (int j = i + 1; track.nearUnlike && j < count; j++) {
        Track other = tracks[j];
        if (other.nearUnlike && other.hasSeenCluster() && track.movesUnlike(other)) {
          readings.keepApart(index, other.batch.index, timeUs + settings.updateIntervalUs());
        }
      }
      if (track.contested) {
        readings.keepAlive(index, timeUs + SHOWN_WITHOUT_CLUSTER_US);
      }
    }
  }
}
