package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.filters.trail.TrailPoint;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class ClusterTrackerFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final long SECOND_US = 1_000_000;
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 35, SECOND_US, 6);

  private final List<ClusterTrack> tracks = new ArrayList<>();
  private final List<TrailSnapshot> snapshots = new ArrayList<>();

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new ClusterTrackerFilter(geometry, ClusterTrackerSettings.defaults());
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    BlobPath path =
        new BlobPath(
            geometry.width() / 2.0, geometry.height() / 2.0, geometry.height() / 3.0, 7e5, 3);
    return EventPackets.blob(geometry, seed, SECOND_US, path, 30_000, 2);
  }

  @Override
  protected Object withoutIdentity(Object result) {
    if (result instanceof ClusterTrack track) {
      return anonymous(track);
    }
    return ((TrailSnapshot) result)
        .trails().stream()
            .map(trail -> trail.path().stream().map(this::withoutIdentity).toList())
            .toList();
  }

  private static ClusterTrack anonymous(ClusterTrack track) {
    return new ClusterTrack(
        track.timeUs(),
        0,
        track.xPx(),
        track.yPx(),
        track.vxPxS(),
        track.vyPxS(),
        track.radiusPx(),
        track.aspect(),
        track.angleRad(),
        track.events(),
        track.mass(),
        track.rateHz(),
        track.ageUs());
  }

  private ClusterTrackerFilter subscribed(String... changes) {
    ClusterTrackerFilter filter =
        new ClusterTrackerFilter(SENSOR, ClusterTrackerSettings.defaults().with(changes));
    filter.outlets().get(0).subscribe(result -> tracks.add((ClusterTrack) result));
    filter.outlets().get(1).subscribe(result -> snapshots.add((TrailSnapshot) result));
    return filter;
  }

  private void run(EventPacket events) {
    subscribed().process(events);
  }

  private Set<Integer> identities() {
    return tracks.stream().map(ClusterTrack::id).collect(Collectors.toSet());
  }

  @Test
  void movingBlobIsOneClusterWithItsPositionAndVelocity() {
    run(EventPackets.blob(SENSOR, 1, 3 * SECOND_US, CIRCLE, 50_000, 0));
    assertEquals(Set.of(1), identities());
    assertEquals(0, tracks.get(0).timeUs() % 10_000);
    assertTrue(tracks.size() >= 298, "reports: " + tracks.size());
    double speed = 2 * Math.PI * CIRCLE.circleRadiusPx();
    for (ClusterTrack track : tracks) {
      if (track.timeUs() > 500_000) {
        // Four standard deviations of the mean of some 40 events of a disc of 6 px.
        assertEquals(CIRCLE.x(track.timeUs()), track.xPx(), 2, track::toString);
        assertEquals(CIRCLE.y(track.timeUs()), track.yPx(), 2, track::toString);
        double angle = 2 * Math.PI * track.timeUs() / SECOND_US;
        double off =
            Math.hypot(
                track.vxPxS() + speed * Math.sin(angle), track.vyPxS() - speed * Math.cos(angle));
        // A velocity averaged over 0.1 s lags by 36 degrees on a round of a second.
        assertTrue(off < 0.75 * speed, off + " px/s off: " + track);
        assertEquals(speed, Math.hypot(track.vxPxS(), track.vyPxS()), 0.35 * speed);
      }
    }
  }

  @Test
  void twoBlobsAreTwoClustersAndKeepTheirIdentities() {
    BlobPath left = new BlobPath(30, 64, 15, SECOND_US, 5);
    BlobPath right = new BlobPath(98, 64, 15, 700_000, 5);
    run(
        ClusterRun.merged(
            EventPackets.blob(SENSOR, 3, 2 * SECOND_US, left, 20_000, 0),
            EventPackets.blob(SENSOR, 4, 2 * SECOND_US, right, 20_000, 0)));
    assertEquals(Set.of(1, 2), identities());
    ClusterTrack first = tracks.stream().filter(track -> track.id() == 1).findFirst().orElseThrow();
    boolean firstIsLeft = first.xPx() < 64;
    for (ClusterTrack track : tracks) {
      if (track.timeUs() > 300_000) {
        BlobPath truth = (track.id() == 1) == firstIsLeft ? left : right;
        assertEquals(truth.x(track.timeUs()), track.xPx(), 2);
        assertEquals(truth.y(track.timeUs()), track.yPx(), 2);
      }
    }
  }

  @Test
  void clusterWithoutEventsExpiresAndIsReportedOnce() {
    EventPacket blob = EventPackets.blob(SENSOR, 8, 200_000, CIRCLE, 50_000, 0);
    blob.append(5 * SECOND_US, 0, 0, true);
    run(blob);
    // The mass falls from 2500 to 10 in 0.28 s.
    long lastUs = tracks.get(tracks.size() - 1).timeUs();
    assertTrue(lastUs > 400_000 && lastUs < 520_000, "last seen at " + lastUs);
    TrailSnapshot last = snapshots.get(snapshots.size() - 1);
    assertTrue(last.trails().isEmpty());
    assertEquals(lastUs + 10_000, last.timeUs());
    assertEquals(tracks.size() + 1, snapshots.size());
  }

  @Test
  void identitiesAreNeverReusedEvenAfterAReset() {
    EventPacket blob = EventPackets.blob(SENSOR, 9, 200_000, CIRCLE, 50_000, 0);
    ClusterTrackerFilter filter = subscribed();
    filter.process(EventPackets.copy(blob));
    assertEquals(Set.of(1), identities());
    tracks.clear();
    filter.reset();
    filter.process(EventPackets.copy(blob));
    assertEquals(Set.of(2), identities());
  }

  @Test
  void gapsShorterThanALifetimeAreBridged() {
    EventPacket blob = EventPackets.blob(SENSOR, 11, 400_000, CIRCLE, 50_000, 0);
    ClusterTrackerFilter filter = subscribed();
    filter.process(EventPackets.part(blob, 0, blob.indexAtOrAfter(200_000)));
    filter.notified(new DataLost(512, 128, 200_000, 210_000, "the test"));
    filter.process(EventPackets.part(blob, blob.indexAtOrAfter(210_000), blob.size()));
    assertEquals(Set.of(1), identities());
    assertEquals(390_000, tracks.get(tracks.size() - 1).timeUs());
  }

  @Test
  void newSettingsKeepExistingClusters() {
    ClusterTrackerFilter filter = subscribed();
    EventPacket blob = EventPackets.blob(SENSOR, 12, 400_000, CIRCLE, 50_000, 0);
    int half = blob.indexAtOrAfter(200_000);
    filter.process(EventPackets.part(blob, 0, half));
    filter.apply(
        ClusterTrackerSettings.defaults()
            .with(
                "shape.size=0.15",
                "motion.weight=per-time",
                "output.maxClusters=1",
                "output.reportRateHz=50"));
    filter.process(EventPackets.part(blob, half, blob.size()));
    assertEquals(Set.of(1), identities());
    ClusterTrack last = tracks.get(tracks.size() - 1);
    assertNotEquals(tracks.get(0).radiusPx(), last.radiusPx());
    assertEquals(20_000, last.timeUs() - tracks.get(tracks.size() - 2).timeUs());
  }

  @Test
  void snapshotContainsThePathOfEachCluster() {
    run(EventPackets.blob(SENSOR, 13, 2 * SECOND_US, CIRCLE, 50_000, 0));
    TrailSnapshot last = snapshots.get(snapshots.size() - 1);
    List<TrailPoint> path = last.trails().get(0).path();
    assertEquals(100, path.size());
    assertEquals(tracks.subList(tracks.size() - 100, tracks.size()), path);
    assertEquals(last.timeUs(), last.trails().get(0).now().timeUs());
  }

  @Test
  void onlyEventsOfVisibleClustersPassOnRequest() {
    EventPacket blob = EventPackets.blob(SENSOR, 14, 500_000, CIRCLE, 20_000, 0);
    EventPacket noise = EventPackets.uniform(SENSOR, 15, 500, 0, 1000);
    EventPacket events = ClusterRun.merged(blob, noise);
    subscribed("output.onlyClustered=true").process(events);
    assertEquals(blob.size(), events.size(), 0.05 * blob.size());
  }
}
