package haltere.filters.track;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle.Role;
import haltere.filters.estimation.Gate;
import haltere.filters.plane.PlanePoint;
import haltere.filters.trail.internal.TrailMark;
import haltere.filters.trail.internal.TrailOverlay;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.filters.trail.internal.Trails;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * {@link KalmanTracks} as a stage of a chain. Publishes at each report a {@link TrackPoint} for
 * each track in the picture and, where there is a road, a {@link PlanePoint} right after it; and a
 * {@link TrackUpdate} for each update of each track.
 */
public final class KalmanTracksFilter extends PublishingFilter<KalmanTracksSettings> {
  /** Distance of a label from the position, pixels: beside an ellipse of usual size. */
  private static final double LABEL_PX = 3;

  /** Half axes of the ellipse that holds 95 %, over standard deviations. */
  private static final double RADII_OF_95_PERCENT = Math.sqrt(Gate.probability(0.95).threshold(2));

  private final Outlet<TrackPoint> points = outlet("tracks", TrackPoint.class);
  private final Outlet<PlanePoint> roadPoints = outlet("road-tracks", PlanePoint.class);
  private final Outlet<TrackUpdate> updates = outlet("estimates", TrackUpdate.class);
  private final Outlet<TrailSnapshot> snapshots =
      drawnOutlet("track-snapshot", TrailSnapshot.class, "tracks", new TrailOverlay());
  private final Trails trails = new Trails();
  private final KalmanTracks tracks;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
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
      tracks.forEach(timeUs, track -> publish(track, drawn));
      snapshots.publish(trails.at(timeUs));
    }
  }

  private void publish(TrackPrediction track, boolean drawn) {
    TrackPoint point = track.point();
    Optional<PlanePoint> onRoad =
        settings().road().mapToRoad() ? Optional.of(track.planePoint()) : Optional.empty();
    points.publish(point);
    onRoad.ifPresent(roadPoints::publish);
    if (drawn) {
      trails.add(point, mark(track, onRoad), settings().clusters().output().pathPoints());
    }
  }

  /** The ellipse that holds the position with 95 % probability, and on a road the speed. */
  private static TrailMark mark(TrackPrediction track, Optional<PlanePoint> onRoad) {
    String id = Integer.toString(track.track.id);
    return new TrailMark(
        track.track.cluster == null ? Role.WARNING : Role.UNCERTAINTY,
        track.ellipse().times(RADII_OF_95_PERCENT),
        false,
        onRoad
            .map(point -> String.format(Locale.ROOT, "%s: %.0f km/h", id, point.speedKmH()))
            .orElse(id),
        LABEL_PX);
  }

  @Override
  public void process(EventPacket packet) {
    tracks.track(packet);
  }

  @Override
  public void reset() {
    tracks.reset();
    trails.clear();
  }

  /** {@inheritDoc} Identities restart. */
  @Override
  public void rewind() {
    reset();
    tracks.restartIdentities();
  }

  /** Time continues over a gap in the data, with the usual coasting of tracks. */
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

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<KalmanTracksSettings> {
    /** Called by the service loader. */
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
