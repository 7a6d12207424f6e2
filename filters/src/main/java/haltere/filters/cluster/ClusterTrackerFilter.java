package haltere.filters.cluster;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle.Role;
import haltere.filters.trail.internal.TrailMark;
import haltere.filters.trail.internal.TrailOverlay;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.filters.trail.internal.Trails;
import java.util.List;
import java.util.Map;

/**
 * {@link ClusterTracker} as a stage of a chain. Publishes a {@link ClusterTrack} for each visible
 * cluster at each report, and all of them together as a {@link TrailSnapshot}, also once when there
 * are none left. Passes all events unless set otherwise.
 */
public final class ClusterTrackerFilter extends PublishingFilter<ClusterTrackerSettings> {
  private final Outlet<ClusterTrack> clusters = outlet("clusters", ClusterTrack.class);
  private final Outlet<TrailSnapshot> snapshots =
      drawnOutlet("snapshot", TrailSnapshot.class, "clusters", new TrailOverlay());
  private final Trails trails = new Trails();
  private final ClusterTracker tracker;
  private boolean showing;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public ClusterTrackerFilter(SensorGeometry geometry, ClusterTrackerSettings settings) {
    tracker = new ClusterTracker(geometry, settings, new Publisher());
  }

  private final class Publisher implements ClusterListener {
    @Override
    public void reported(long timeUs) {
      showing = (clusters.hasSubscribers() || snapshots.hasSubscribers()) && publish(timeUs);
    }

    @Override
    public boolean isWaiting() {
      return showing;
    }
  }

  /** Publishes the visible clusters; false if there are none. */
  private boolean publish(long timeUs) {
    List<ClusterTrack> tracks = tracker.tracks(timeUs);
    for (ClusterTrack track : tracks) {
      clusters.publish(track);
      trails.add(track, mark(track), settings().output().pathPoints());
    }
    TrailSnapshot snapshot = trails.at(timeUs);
    if (showing || !tracks.isEmpty()) {
      snapshots.publish(snapshot);
    }
    return !tracks.isEmpty();
  }

  private TrailMark mark(ClusterTrack track) {
    return new TrailMark(
        Role.OBJECT,
        track.ellipse(),
        settings().shape().type() == ClusterShapeSettings.Type.BOX,
        Integer.toString(track.id()),
        track.radiusPx() * Math.sqrt(0.5));
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void reset() {
    tracker.reset();
    trails.clear();
    showing = false;
  }

  /** {@inheritDoc} Identities restart. */
  @Override
  public void rewind() {
    reset();
    tracker.restartIdentities();
  }

  /** Time continues over a gap in the data, with the usual life of clusters. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public ClusterTrackerSettings settings() {
    return tracker.settings();
  }

  @Override
  public void apply(ClusterTrackerSettings settings) {
    tracker.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<ClusterTrackerSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "cluster-tracker",
          "Tracks clusters of events, boxes or ellipses that events move (Cardinale, 2006).",
          ClusterTrackerSettings.class,
          ClusterTrackerFilter::new);
    }

    @Override
    public Map<String, ClusterTrackerSettings> presets() {
      return Map.of("original", ClusterTrackerSettings.original());
    }
  }
}
