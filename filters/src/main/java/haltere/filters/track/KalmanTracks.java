package haltere.filters.track;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.Cluster;
import haltere.filters.cluster.ClusterListener;
import haltere.filters.cluster.ClusterTracker;
import haltere.filters.estimation.Assignment;
import haltere.filters.estimation.Gate;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.RoadMapping;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongConsumer;

/**
 * Kalman filters on clusters: J. Cardinale (2006), "Tracking objects and wing beat analysis methods
 * of a fruit fly with the event-based silicon retina", part I, section 2.
 *
 * <p>A track starts at a visible cluster after a number of events, and is updated by its location
 * after the same number again. Its identity follows that of the cluster. Without a visible cluster
 * it coasts on its prediction; new clusters inside the gates of coasting tracks are assigned to
 * them all at once, by least squared Mahalanobis distance.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
final class KalmanTracks {
  private final SensorGeometry geometry;
  private final LongConsumer atReport;
  private final ClusterTracker clusters;
  private final List<Track> tracks = new ArrayList<>();
  private final List<Cluster> unassigned = new ArrayList<>();
  private KalmanTracksSettings settings;
  private PlaneMapping mapping;
  private TrackPrediction prediction;
  private Assignment assignment;
  private double gate;
  private int maxTracks;
  private int lastId;
  private long nextUpdateUs = Long.MIN_VALUE;
  private long countedEvents;
  private boolean showing;
  private BooleanSupplier wantsUpdates = () -> false;
  private Consumer<TrackUpdate> updates = update -> {};

  /**
   * Tracks in their initial state. At each report time, while there is a track and once when there
   * are none left, atReport is called; it may call {@link #forEach}.
   */
  public KalmanTracks(
      SensorGeometry geometry, KalmanTracksSettings settings, LongConsumer atReport) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.atReport = Objects.requireNonNull(atReport, "atReport");
    clusters = new ClusterTracker(geometry, settings.clusters(), new Below());
    apply(settings);
  }

  /** Receives updates of the clusters. */
  private final class Below implements ClusterListener {
    @Override
    public void updated(long timeUs) {
      if (timeUs >= nextUpdateUs) {
        look(timeUs);
        long intervalUs = settings.life().trackIntervalUs();
        nextUpdateUs = (Math.floorDiv(timeUs, intervalUs) + 1) * intervalUs;
      }
    }

    @Override
    public void reported(long timeUs) {
      if (showing || !tracks.isEmpty()) {
        showing = !tracks.isEmpty();
        atReport.accept(timeUs);
      }
    }

    @Override
    public boolean isWaiting() {
      return showing || !tracks.isEmpty();
    }
  }

  /** Sets an observer of updates, while requested; an observed update allocates. */
  void observe(BooleanSupplier wanted, Consumer<TrackUpdate> observer) {
    wantsUpdates = wanted;
    updates = observer;
  }

  /** Removes all tracks and clusters. Their identities are not reused. */
  public void reset() {
    clusters.reset();
    tracks.clear();
    nextUpdateUs = Long.MIN_VALUE;
    countedEvents = clusters.eventCount();
    showing = false;
  }

  /** Restarts identities from the first one. */
  public void restartIdentities() {
    clusters.restartIdentities();
    lastId = 0;
  }

  /** {@return the settings in force} */
  public KalmanTracksSettings settings() {
    return settings;
  }

  /**
   * Applies new settings from the next packet on. Tracks and clusters continue unless the road
   * changes: then tracks restart.
   */
  public void apply(KalmanTracksSettings newSettings) {
    if (settings == null || !settings.road().equals(newSettings.road())) {
      mapping =
          newSettings.road().mapToRoad()
              ? new RoadMapping(newSettings.road().view(), geometry)
              : PlaneMapping.PICTURE;
      tracks.clear();
    }
    settings = newSettings;
    prediction = new TrackPrediction(mapping, settings);
    int maxClusters = settings.clusters().output().maxClusters();
    // as many tracks may coast as there may be clusters
    maxTracks = 2 * maxClusters;
    tracks.subList(Math.min(maxTracks, tracks.size()), tracks.size()).clear();
    assignment = new Assignment(maxTracks, maxClusters);
    gate = Gate.sigmas(settings.life().gateSigmas()).threshold(2);
    clusters.apply(settings.clusters());
  }

  /** Processes events; a packet is only read, unless events outside clusters are to be removed. */
  public void track(EventPacket packet) {
    clusters.track(packet);
  }

  /** Passes on each track in the picture, predicted to a time. */
  void forEach(long timeUs, Consumer<TrackPrediction> action) {
    for (Track track : tracks) {
      if (prediction.predict(track, timeUs) && isInPicture()) {
        action.accept(prediction);
      }
    }
  }

  private boolean isInPicture() {
    return prediction.xPx >= -0.5
        && prediction.yPx >= -0.5
        && prediction.xPx <= geometry.width() - 0.5
        && prediction.yPx <= geometry.height() - 0.5;
  }

  /** Assigns, starts, updates and ends tracks of the clusters. Allocates for births only. */
  private void look(long timeUs) {
    unassigned.clear();
    for (int i = 0; i < tracks.size(); i++) {
      tracks.get(i).cluster = null;
    }
    for (int i = 0; i < clusters.count(); i++) {
      Cluster cluster = clusters.cluster(i);
      if (cluster.isVisible() && !isFollowed(cluster, timeUs)) {
        unassigned.add(cluster);
      }
    }
    assign(timeUs);
    boolean together = settings.life().eventsOf() == TrackLifeSettings.EventCount.ALL_CLUSTERS;
    int wanted = settings.life().eventsTillTrack();
    boolean isDue = together && clusters.eventCount() - countedEvents >= wanted;
    if (isDue) {
      countedEvents = clusters.eventCount();
    }
    for (int i = 0; i < tracks.size(); i++) {
      Track track = tracks.get(i);
      long events = track.newEvents();
      if (events > 0 && (together ? isDue : events >= wanted)) {
        update(track, timeUs);
      }
      if (isOver(track, timeUs)) {
        tracks.remove(i--);
      }
    }
    for (int i = 0; i < unassigned.size(); i++) {
      Cluster cluster = unassigned.get(i);
      boolean isReady = together ? isDue : cluster.eventCount() >= wanted;
      if (isReady && tracks.size() < maxTracks && mapping.seesPlane(cluster.xPx(), cluster.yPx())) {
        Track born = new Track(++lastId);
        born.follow(cluster, timeUs);
        prediction.start(born);
        tracks.add(born);
      }
    }
  }

  /** Whether a cluster has a track, which is then marked as visible. */
  private boolean isFollowed(Cluster cluster, long timeUs) {
    for (int i = 0; i < tracks.size(); i++) {
      Track track = tracks.get(i);
      if (track.clusterId == cluster.id()) {
        track.cluster = cluster;
        track.seenUs = timeUs;
        return true;
      }
    }
    return false;
  }

  /** Assigns clusters without a track to tracks without a cluster. */
  private void assign(long timeUs) {
    if (unassigned.isEmpty()) {
      return;
    }
    assignment.start(tracks.size(), unassigned.size());
    for (int i = 0; i < tracks.size(); i++) {
      Track track = tracks.get(i);
      boolean isCoasting = track.cluster == null && prediction.predict(track, timeUs);
      for (int j = 0; isCoasting && j < unassigned.size(); j++) {
        Cluster cluster = unassigned.get(j);
        double distance2 = prediction.distance2(cluster.xPx(), cluster.yPx());
        if (distance2 <= gate) {
          assignment.setCost(i, j, distance2);
        }
      }
    }
    assignment.solve(gate, gate);
    for (int j = unassigned.size() - 1; j >= 0; j--) {
      int row = assignment.rowOf(j);
      if (row != Assignment.NONE) {
        tracks.get(row).follow(unassigned.remove(j), timeUs);
      }
    }
  }

  private void update(Track track, long timeUs) {
    track.initialShare *= 1 - settings.filter().varianceMixingFactor();
    if (!mapping.seesPlane(track.cluster.xPx(), track.cluster.yPx())
        || !prediction.predict(track, timeUs)) {
      return;
    }
    TrackUpdate update = prediction.correct(wantsUpdates.getAsBoolean());
    if (update != null) {
      updates.accept(update);
    }
    if (settings.life().feedbackToCluster() && prediction.predict(track, timeUs)) {
      clusters.move(track.cluster, prediction.xPx, prediction.yPx);
    }
  }

  /** Whether a track has coasted for too long, or has left the plane or picture. */
  private boolean isOver(Track track, long timeUs) {
    boolean isSeen = prediction.predict(track, timeUs);
    boolean isLost = timeUs - track.seenUs > 1e6 * settings.life().coastTimeS();
    return !isSeen || track.cluster == null && (isLost || !isInPicture());
  }
}
