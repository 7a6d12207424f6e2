package haltere.filters.cluster;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * {@link ClusterTracker} as a stage of a chain. Lets all events through; publishes a {@link
 * ClusterTrack} for each visible cluster at each report, and all of them together as a {@link
 * ClusterSnapshot}.
 */
public final class ClusterTrackerFilter extends PublishingFilter<ClusterTrackerSettings> {
  private final Outlet<ClusterTrack> clusters = outlet("clusters", ClusterTrack.class);
  private final Outlet<ClusterSnapshot> snapshot =
      drawnOutlet("snapshot", ClusterSnapshot.class, "clusters", new ClusterTrackOverlay());
  private final ClusterTracker tracker;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   */
  public ClusterTrackerFilter(SensorGeometry geometry, ClusterTrackerSettings settings) {
    tracker = new ClusterTracker(geometry, settings, this::publish);
  }

  private void publish(long timeUs) {
    if (clusters.hasSubscribers()) {
      tracker.tracks().forEach(clusters::publish);
    }
    if (snapshot.hasSubscribers()) {
      snapshot.publish(tracker.snapshot(timeUs));
    }
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void reset() {
    tracker.reset();
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
  public static final class Provider implements FilterProvider<ClusterTrackerSettings> {
    @Override
    public String name() {
      return "cluster-tracker";
    }

    @Override
    public String description() {
      return "Follows things that move as clusters of events.";
    }

    @Override
    public Class<ClusterTrackerSettings> settingsType() {
      return ClusterTrackerSettings.class;
    }

    @Override
    public ClusterTrackerFilter create(SensorGeometry geometry, ClusterTrackerSettings settings) {
      return new ClusterTrackerFilter(geometry, settings);
    }
  }
}
