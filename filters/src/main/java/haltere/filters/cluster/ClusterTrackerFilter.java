package haltere.filters.cluster;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * {@link ClusterTracker} as a stage of a chain. Publishes a {@link ClusterTrack} for each visible
 * cluster at each report, and all of them together as a {@link ClusterSnapshot}, once also when
 * there is none any more. Passes all events on unless its settings say otherwise.
 */
public final class ClusterTrackerFilter extends PublishingFilter<ClusterTrackerSettings> {
  private final Outlet<ClusterTrack> clusters = outlet("clusters", ClusterTrack.class);
  private final Outlet<ClusterSnapshot> snapshots =
      drawnOutlet("snapshot", ClusterSnapshot.class, "clusters", new ClusterTrackOverlay());
  private final Paths<ClusterTrack> paths = new Paths<>();
  private final ClusterTracker tracker;
  private boolean showing;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
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

  /** Publishes what is visible; false if nothing is. */
  private boolean publish(long timeUs) {
    List<ClusterTrack> tracks = tracker.tracks(timeUs);
    tracks.forEach(clusters::publish);
    Set<Integer> ids = tracks.stream().map(ClusterTrack::id).collect(Collectors.toSet());
    paths.keep(ids);
    if (snapshots.hasSubscribers() && (showing || !tracks.isEmpty())) {
      int maxLength = settings().output().pathPoints();
      snapshots.publish(
          new ClusterSnapshot(
              timeUs,
              settings().shape().type(),
              tracks.stream()
                  .map(track -> new ClusterSnapshot.Trail(paths.add(track.id(), track, maxLength)))
                  .toList()));
    }
    return !tracks.isEmpty();
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void reset() {
    tracker.reset();
    paths.keep(Set.of());
    showing = false;
  }

  /** {@inheritDoc} Identities begin anew. */
  @Override
  public void rewind() {
    reset();
    tracker.restartIdentities();
  }

  /** Time goes on over a gap in the data, and clusters live on for as long as they live anyway. */
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

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider extends NamedProvider<ClusterTrackerSettings> {
    /** Found by its name in the list of services. */
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
