package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.dots.DotTruth;
import haltere.core.simulation.dots.MovingDotsScene;
import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.noise.BackgroundActivity;
import haltere.filters.noise.BackgroundActivitySettings;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class ClusterTrackerFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final long SECOND_US = 1_000_000;
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 35, SECOND_US, 6);

  private final List<ClusterTrack> tracks = new ArrayList<>();
  private final List<ClusterSnapshot> snapshots = new ArrayList<>();

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
    return ((ClusterSnapshot) result)
        .clusters().stream()
            .map(trail -> trail.path().stream().map(ClusterTrackerFilterTest::anonymous).toList())
            .toList();
  }

  private static ClusterTrack anonymous(ClusterTrack track) {
    return new ClusterTrack(
        track.timeUs(),
        0,
        track.xPx(),
        track.yPx(),
        track.vxPxPerS(),
        track.vyPxPerS(),
        track.radiusPx(),
        track.aspect(),
        track.angleRad(),
        track.events(),
        track.mass(),
        track.rateHz(),
        track.ageUs());
  }

  @Test
  void aBlobThatMovesThroughNoiseIsFollowedAsOneClusterWithinAPixelAndAHalf() {
    run(EventPackets.blob(SENSOR, 1, 3 * SECOND_US, CIRCLE, 50_000, 1));
    assertEquals(Set.of(1), identities());
    assertEquals(0, tracks.get(0).timeUs() % 10_000);
    assertTrue(tracks.size() >= 298, "reports: " + tracks.size());
    for (ClusterTrack track : tracks) {
      double error =
          Math.hypot(
              track.xPx() - CIRCLE.x(track.timeUs()), track.yPx() - CIRCLE.y(track.timeUs()));
      assertTrue(error < 1.5, error + " px from the truth: " + track);
    }
  }

  @Test
  void theVelocityIsThatOfTheBlob() {
    run(EventPackets.blob(SENSOR, 2, 3 * SECOND_US, CIRCLE, 50_000, 1));
    double speed = 2 * Math.PI * CIRCLE.circleRadiusPx();
    for (ClusterTrack track : tracks) {
      if (track.timeUs() > 500_000) {
        double angle = 2 * Math.PI * track.timeUs() / SECOND_US;
        double error =
            Math.hypot(
                track.vxPxPerS() + speed * Math.sin(angle),
                track.vyPxPerS() - speed * Math.cos(angle));
        assertTrue(error < 0.25 * speed, error + " px/s off: " + track);
      }
    }
  }

  @Test
  void twoBlobsAreTwoClustersAndKeepTheirIdentities() {
    BlobPath left = new BlobPath(30, 64, 15, SECOND_US, 5);
    BlobPath right = new BlobPath(98, 64, 15, 700_000, 5);
    EventPacket events =
        merged(
            EventPackets.blob(SENSOR, 3, 2 * SECOND_US, left, 20_000, 1),
            EventPackets.blob(SENSOR, 4, 2 * SECOND_US, right, 20_000, 0));
    run(events);
    assertEquals(Set.of(1, 2), identities());
    ClusterTrack first = tracks.stream().filter(track -> track.id() == 1).findFirst().orElseThrow();
    boolean firstIsLeft = first.xPx() < 64;
    for (ClusterTrack track : tracks) {
      BlobPath truth = (track.id() == 1) == firstIsLeft ? left : right;
      assertEquals(truth.x(track.timeUs()), track.xPx(), 1.5);
      assertEquals(truth.y(track.timeUs()), track.yPx(), 1.5);
    }
  }

  @Test
  void twoThingsThatAppearAtOnceAreBothSeenAsSoonAsTheirSizeShowsThatTheyAreApart() {
    BlobPath left = new BlobPath(55, 64, 0, SECOND_US, 2);
    BlobPath right = new BlobPath(72, 64, 0, SECOND_US, 2);
    run(
        merged(
            EventPackets.blob(SENSOR, 5, 100_000, left, 6_000, 0),
            EventPackets.blob(SENSOR, 6, 100_000, right, 6_000, 0)));
    long bothUs =
        tracks.stream().filter(track -> track.id() == 2).findFirst().orElseThrow().timeUs();
    assertTrue(bothUs <= 40_000, "the second one after " + bothUs + " us");
    assertEquals(Set.of(1, 2), identities());
  }

  @Test
  void noiseAloneShowsNothingAndDoesNotHideABlob() {
    run(EventPackets.uniform(SENSOR, 5, 50_000, 0, 60));
    assertTrue(tracks.isEmpty(), "clusters in pure noise: " + tracks.size());
    EventPacket noisy =
        merged(
            EventPackets.uniform(SENSOR, 6, 16_000, 0, 60),
            EventPackets.blob(SENSOR, 7, SECOND_US, CIRCLE, 20_000, 0));
    run(noisy);
    assertEquals(1, identities().size(), "one cluster in noise: " + identities());
  }

  @Test
  void aClusterWithoutEventsDiesAfterItsLifetimeAndIsLastReportedAsGone() {
    EventPacket blob = EventPackets.blob(SENSOR, 8, 200_000, CIRCLE, 50_000, 0);
    blob.append(5 * SECOND_US, 0, 0, true);
    run(blob);
    assertEquals(290_000, tracks.get(tracks.size() - 1).timeUs());
    ClusterSnapshot last = snapshots.get(snapshots.size() - 1);
    assertTrue(last.clusters().isEmpty());
    assertEquals(300_000, last.timeUs());
    assertEquals(tracks.size() + 1, snapshots.size());
  }

  @Test
  void aSimulatedDotIsWhereTheTruthSaysItIs() {
    MovingDotsScene scene =
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with(
                    "dots.count=1", "dots.eventsPerPixel=5", "dots.radiusPx=5", "run.durationS=2"));
    EventPacket events = eventsOf(scene);
    new BackgroundActivity(scene.geometry(), BackgroundActivitySettings.defaults()).filter(events);
    run(events);
    assertTrue(tracks.size() > 150, "reports: " + tracks.size());
    for (ClusterTrack track : tracks) {
      DotTruth truth = scene.truthRows(track.timeUs()).get(0);
      double error = Math.hypot(track.xPx() - truth.xPx(), track.yPx() - truth.yPx());
      assertTrue(error < 2, error + " px from the truth: " + track);
    }
  }

  private static EventPacket eventsOf(MovingDotsScene scene) {
    EventPacket events = new EventPacket(0);
    StreamHandler collector =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            events.append(packet, 0, packet.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            // Only the events are wanted.
          }
        };
    while (scene.next(collector)) {
      // Until the end.
    }
    return events;
  }

  @Test
  void identitiesAreNotGivenOutTwiceNotEvenAfterAReset() {
    EventPacket blob = EventPackets.blob(SENSOR, 9, 200_000, CIRCLE, 50_000, 0);
    ClusterTrackerFilter filter = subscribed(ClusterTrackerSettings.defaults());
    filter.process(EventPackets.copy(blob));
    Set<Integer> before = identities();
    tracks.clear();
    filter.reset();
    filter.process(EventPackets.copy(blob));
    assertEquals(Set.of(1), before);
    assertEquals(Set.of(2), identities());
  }

  @Test
  void clustersThatOverlapMergeIntoTheHeavierOne() {
    SplittableRandom random = new SplittableRandom(20);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 3_000_000; timeUs += 50) {
      // A thing that stands still, and a lighter one that comes nearer and stays.
      events.append(timeUs, 64 + random.nextInt(-4, 5), 64 + random.nextInt(-4, 5), true);
      if (timeUs % 100 == 0) {
        int place = Math.max(66, 110 - (int) (timeUs / 10_000));
        events.append(timeUs, place + random.nextInt(-4, 5), 64 + random.nextInt(-4, 5), true);
      }
    }
    run(events);
    assertTrue(
        tracks.stream().filter(track -> track.timeUs() == 100_000).count() == 2, "two at first");
    List<ClusterTrack> end = tracks.stream().filter(track -> track.timeUs() == 2_990_000).toList();
    assertEquals(1, end.size());
    ClusterTrack early =
        tracks.stream().filter(track -> Math.abs(track.xPx() - 64) < 1).findFirst().orElseThrow();
    assertEquals(early.id(), end.get(0).id());
  }

  @Test
  void thereAreNeverMoreClustersThanAllowed() {
    ClusterTrackerFilter filter =
        subscribed(ClusterTrackerSettings.defaults().with("output.mostClusters=3"));
    EventPacket events = EventPackets.blob(SENSOR, 20, SECOND_US, CIRCLE, 20_000, 1);
    for (int i = 1; i < 8; i++) {
      BlobPath path = new BlobPath(16 + 14 * i, 64, 4 + 2 * i, SECOND_US, 3);
      events = merged(events, EventPackets.blob(SENSOR, 20 + i, SECOND_US, path, 20_000, 0));
    }
    filter.process(events);
    assertTrue(snapshots.size() > 10);
    for (ClusterSnapshot snapshot : snapshots) {
      assertTrue(snapshot.clusters().size() <= 3);
    }
  }

  @Test
  void aGapInTheDataThatIsShorterThanALifetimeIsBridged() {
    EventPacket blob = EventPackets.blob(SENSOR, 11, 400_000, CIRCLE, 50_000, 0);
    ClusterTrackerFilter filter = subscribed(ClusterTrackerSettings.defaults());
    filter.process(EventPackets.part(blob, 0, blob.indexAtOrAfter(200_000)));
    filter.notified(new DataLost(512, 128, 200_000, 210_000, "the test"));
    filter.process(EventPackets.part(blob, blob.indexAtOrAfter(210_000), blob.size()));
    assertEquals(Set.of(1), identities());
    assertEquals(390_000, tracks.get(tracks.size() - 1).timeUs());
  }

  @Test
  void newSettingsAreTakenWithTheClustersThatThereAre() {
    ClusterTrackerFilter filter = subscribed(ClusterTrackerSettings.defaults());
    EventPacket blob = EventPackets.blob(SENSOR, 12, 400_000, CIRCLE, 50_000, 0);
    int half = blob.indexAtOrAfter(200_000);
    filter.process(EventPackets.part(blob, 0, half));
    filter.apply(
        ClusterTrackerSettings.defaults()
            .with(
                "growth.size=false",
                "form.size=0.15",
                "output.mostClusters=1",
                "output.reportRateHz=50"));
    filter.process(EventPackets.part(blob, half, blob.size()));
    assertEquals(Set.of(1), identities());
    ClusterTrack first = tracks.get(0);
    ClusterTrack last = tracks.get(tracks.size() - 1);
    assertNotEquals(first.radiusPx(), last.radiusPx());
    assertEquals(20_000, last.timeUs() - tracks.get(tracks.size() - 2).timeUs());
  }

  @Test
  void aSnapshotHoldsThePathOfEachCluster() {
    run(EventPackets.blob(SENSOR, 13, 2 * SECOND_US, CIRCLE, 50_000, 0));
    ClusterSnapshot last = snapshots.get(snapshots.size() - 1);
    List<ClusterTrack> path = last.clusters().get(0).path();
    assertEquals(100, path.size());
    assertEquals(tracks.subList(tracks.size() - 100, tracks.size()), path);
    assertEquals(last.timeUs(), last.clusters().get(0).now().timeUs());
  }

  private void run(EventPacket events) {
    tracks.clear();
    snapshots.clear();
    subscribed(ClusterTrackerSettings.defaults()).process(events);
  }

  private ClusterTrackerFilter subscribed(ClusterTrackerSettings settings) {
    ClusterTrackerFilter filter = new ClusterTrackerFilter(SENSOR, settings);
    filter.outlets().get(0).subscribe(result -> tracks.add((ClusterTrack) result));
    filter.outlets().get(1).subscribe(result -> snapshots.add((ClusterSnapshot) result));
    return filter;
  }

  private Set<Integer> identities() {
    return tracks.stream().map(ClusterTrack::id).collect(Collectors.toSet());
  }

  static EventPacket merged(EventPacket first, EventPacket second) {
    EventPacket merged = new EventPacket(first.size() + second.size());
    int i = 0;
    int j = 0;
    while (i < first.size() || j < second.size()) {
      boolean takeFirst =
          j == second.size() || (i < first.size() && first.timeUs(i) <= second.timeUs(j));
      EventPacket from = takeFirst ? first : second;
      int index = takeFirst ? i++ : j++;
      merged.append(from.timeUs(index), from.address(index));
    }
    return merged;
  }
}
