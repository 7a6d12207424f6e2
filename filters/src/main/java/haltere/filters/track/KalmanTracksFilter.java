package haltere.filters.track;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.Paths;
import haltere.filters.plane.PlanePoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * {@link KalmanTracks} as a stage of a chain. Publishes at each report a {@link TrackPoint} for
 * each track in the picture and, where there is a road, a {@link PlanePoint} right after it; and a
 * {@link TrackUpdate} for each update of each track.
 */
public final class KalmanTracksFilter extends PublishingFilter<KalmanTracksSettings> {
  private final Outlet<TrackPoint> points = outlet("tracks", TrackPoint.class);
  private final Outlet<PlanePoint> roadPoints = outlet("road-tracks", PlanePoint.class);
  private final Outlet<TrackUpdate> updates = outlet("estimates", TrackUpdate.class);
  private final Outlet<TrackSnapshot> snapshots =
      drawnOutlet("track-snapshot", TrackSnapshot.class, "tracks", new TrackOverlay());
  private final Paths<TrackPoint> paths = new Paths<>();
  private final KalmanTracks tracks;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   */
  public KalmanTracksFilter(SensorGeometry geometry, KalmanTracksSettings settings) {
    tracks = new KalmanTracks(geometry, settings, this::report);
    tracks.observe(updates::hasSubscribers, updates::publish);
  }

  /** {@return the outlet of the tracks in the picture} */
  public Outlet<TrackPoint> points() {
    return points;
  }

  /** {@return the outlet of the tracks on the road, each right after its {@link #points point}} */
  public Outlet<PlanePoint> roadPoints() {
    return roadPoints;
  }

  private void report(long timeUs) {
    boolean drawn = snapshots.hasSubscribers();
    if (drawn || points.hasSubscribers() || roadPoints.hasSubscribers()) {
      List<TrackSnapshot.Shown> shown = new ArrayList<>();
      tracks.forEach(timeUs, track -> publish(track, drawn ? shown : null));
      paths.keep(shown.stream().map(track -> track.now().id()).collect(Collectors.toSet()));
      if (drawn) {
        snapshots.publish(new TrackSnapshot(timeUs, shown));
      }
    }
  }

  private void publish(TrackPrediction track, List<TrackSnapshot.Shown> shown) {
    TrackPoint point = track.point();
    Optional<PlanePoint> onRoad =
        settings().road().mapToRoad() ? Optional.of(track.planePoint()) : Optional.empty();
    points.publish(point);
    onRoad.ifPresent(roadPoints::publish);
    if (shown != null) {
      int maxLength = settings().clusters().output().pathPoints();
      shown.add(
          new TrackSnapshot.Shown(
              paths.add(point.id(), point, maxLength),
              track.covarianceXyPx2(),
              track.track.cluster == null,
              onRoad));
    }
  }

  @Override
  public void process(EventPacket packet) {
    tracks.track(packet);
  }

  @Override
  public void reset() {
    tracks.reset();
    paths.keep(Set.of());
  }

  /** {@inheritDoc} Identities begin anew. */
  @Override
  public void rewind() {
    reset();
    tracks.restartIdentities();
  }

  /** Time goes on over a gap in the data, and tracks coast for as long as they do anyway. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public KalmanTracksSettings settings() {
    return tracks.settings();
  }

  @Override
  public void apply(KalmanTracksSettings settings) {
    tracks.apply(settings);
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider extends NamedProvider<KalmanTracksSettings> {
    /** Found by its name in the list of services. */
    public Provider() {
      super(
          "kalman-tracks",
          "Tracks clusters with Kalman filters, in pixels or in metres on a road (Cardinale,"
              + " 2006).",
          KalmanTracksSettings.class,
          KalmanTracksFilter::new);
    }

    @Override
    public Map<String, KalmanTracksSettings> presets() {
      return Map.of("original", KalmanTracksSettings.original());
    }
  }
}
