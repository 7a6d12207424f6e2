package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What single settings of the cluster tracker do to things of known form and motion. */
class ClusterSettingsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 30, 1_000_000, 6);
  private static final BlobPath STILL = new BlobPath(64, 64, 0, 1_000_000, 9);

  private final List<ClusterTrack> rows = new ArrayList<>();
  private ClusterTracker tracker;

  private ClusterTrack lastOf(EventPacket events, String... changes) {
    run(SENSOR, events, changes);
    return rows.get(rows.size() - 1);
  }

  private void run(SensorGeometry sensor, EventPacket events, String... changes) {
    rows.clear();
    tracker =
        new ClusterTracker(
            sensor,
            ClusterTrackerSettings.defaults().with(changes),
            timeUs -> rows.addAll(tracker.tracks()));
    tracker.track(EventPackets.copy(events));
  }

  private static EventPacket blob(long seed, BlobPath path, long durationUs) {
    return EventPackets.blob(SENSOR, seed, durationUs, path, 20_000, 0);
  }

  @Test
  void eventsInTheSurroundTakeMassAwayWhereTheyInhibit() {
    EventPacket events = blob(1, STILL, 500_000);
    double free = massOf(events, "events.inhibition=0.001");
    double inhibited = massOf(events, "events.inhibition=1");
    // Of a thing of 9 px 73 % are within 7.68 px. The others are in the surround, and cost as much.
    assertEquals((0.73 - 0.27) / 0.73, inhibited / free, 0.06);
  }

  private double massOf(EventPacket events, String inhibition) {
    return lastOf(events, "growth.size=false", "form.size=0.06", inhibition).mass();
  }

  @Test
  void theAngleIsThatOfTheVelocityIfItIsToldTo() {
    for (ClusterTrack row : afterAMoment("form.angle=of-velocity", "growth.aspect=true")) {
      double off = row.angleRad() - Math.atan2(row.vyPxPerS(), row.vxPxPerS());
      assertEquals(0, Math.sin(off), 0.1);
    }
    for (ClusterTrack row : afterAMoment("form.angle=fixed", "form.angleDeg=30")) {
      assertEquals(Math.toRadians(30), row.angleRad(), 1e-9);
    }
  }

  private List<ClusterTrack> afterAMoment(String... changes) {
    lastOf(blob(2, CIRCLE, 600_000), changes);
    return rows.stream().filter(row -> row.timeUs() > 200_000).toList();
  }

  @Test
  void whatIsTooSlowIsNotSeen() {
    // 30 px about the middle in a second: 188 px/s.
    EventPacket events = blob(3, CIRCLE, 400_000);
    run(SENSOR, events, "life.leastSpeedPxPerS=300");
    assertEquals(List.of(), rows);
    assertEquals(1, lastOf(events, "life.leastSpeedPxPerS=100").id());
  }

  @Test
  void whatHasTooFewEventsAPixelIsNotSeen() {
    // 20,000 events a second on 113 pixels and some beside them.
    EventPacket events = blob(4, CIRCLE, 400_000);
    run(SENSOR, events, "life.visibleBy=rate", "life.visibleRateHz=400");
    assertEquals(List.of(), rows);
    assertEquals(1, lastOf(events, "life.visibleBy=rate", "life.visibleRateHz=40").id());
  }

  @Test
  void aClusterGrowsNoLargerThanItsScaleAllows() {
    EventPacket events = blob(5, STILL, 500_000);
    assertEquals(
        6.4 * 1.2, lastOf(events, "form.size=0.05", "growth.mostScale=1.2").radiusPx(), 1e-6);
  }

  @Test
  void frictionStopsWhatGetsNoEvents() {
    EventPacket events = blob(6, CIRCLE, 300_000);
    events.append(390_000, 1, 1, true);
    double free = wayWithoutEvents(events, "motion.velocity.frictionTimeUs=0");
    double braked = wayWithoutEvents(events, "motion.velocity.frictionTimeUs=20000");
    assertTrue(free > 10 && braked < 0.5 * free, braked + " px rather than " + free);
  }

  private double wayWithoutEvents(EventPacket events, String change) {
    ClusterTrack end = lastOf(events, change);
    ClusterTrack start =
        rows.stream().filter(row -> row.timeUs() == 300_000).findAny().orElseThrow();
    assertTrue(end.timeUs() > 350_000);
    return Math.hypot(end.xPx() - start.xPx(), end.yPx() - start.yPx());
  }

  @Test
  void whatIsBornBeginsWithTheVelocityOfTheOthersIfItIsToldTo() {
    BlobPath like = new BlobPath(64, 20, 30, 1_000_000, 6);
    BlobPath slow = new BlobPath(64, 64, 30, 1_000_000, 6);
    EventPacket events =
        ClusterTrackerFilterTest.merged(
            blob(7, slow, 500_000), laterOf(blob(8, like, 500_000), 400_000));
    assertTrue(errorOfTheSecond(events, "motion.velocity.start=mean") < 60);
    assertTrue(errorOfTheSecond(events, "motion.velocity.start=zero") > 100);
  }

  private static EventPacket laterOf(EventPacket events, long fromUs) {
    return EventPackets.part(events, events.indexAtOrAfter(fromUs), events.size());
  }

  private double errorOfTheSecond(EventPacket events, String start) {
    lastOf(events, start, "motion.mixing=per-event", "motion.velocity.timeUs=100000");
    ClusterTrack born = rows.stream().filter(row -> row.id() == 2).findFirst().orElseThrow();
    ClusterTrack old =
        rows.stream()
            .filter(row -> row.id() == 1 && row.timeUs() == born.timeUs())
            .findFirst()
            .orElseThrow();
    return Math.hypot(born.vxPxPerS() - old.vxPxPerS(), born.vyPxPerS() - old.vyPxPerS());
  }

  @Test
  void twoThatWereTakenForOneAreTwoOnceTheyMoveApart() {
    BlobPath inner = new BlobPath(64, 64, 16, 4_000_000, 3);
    BlobPath outer = new BlobPath(64, 64, 34, 2_000_000, 3);
    EventPacket events =
        ClusterTrackerFilterTest.merged(blob(9, inner, 1_000_000), blob(10, outer, 1_000_000));
    run(SENSOR, events, "form.size=0.2");
    assertEquals(1, rows.stream().filter(row -> row.timeUs() == 50_000).count());
    List<ClusterTrack> end = rows.stream().filter(row -> row.timeUs() == 990_000).toList();
    assertEquals(2, end.size());
    for (ClusterTrack row : end) {
      double off =
          Math.min(
              Math.hypot(row.xPx() - inner.x(990_000), row.yPx() - inner.y(990_000)),
              Math.hypot(row.xPx() - outer.x(990_000), row.yPx() - outer.y(990_000)));
      assertTrue(off < 1.5, "off by " + off);
    }
  }

  @Test
  void theNoiseOfTenThousandThingsNeitherExceedsTheClustersNorTheTime() {
    SensorGeometry sensor = new SensorGeometry(640, 480);
    // Ten million events a second: a thousand for each of ten thousand things.
    EventPacket events = EventPackets.uniform(sensor, 11, 1_000_000, 0, 0.1);
    for (int y = 0; y < 480; y += 30) {
      BlobPath path = new BlobPath(20 + y, y, 10, 1_000_000, 3);
      events =
          ClusterTrackerFilterTest.merged(
              events, EventPackets.blob(sensor, 12 + y, 100_000, path, 100_000, 0));
    }
    long beforeNs = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    run(sensor, events, "output.mostClusters=10");
    double nsPerEvent =
        (double) (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - beforeNs)
            / events.size();
    long mostAtATime =
        rows.stream()
            .mapToLong(row -> rows.stream().filter(other -> other.timeUs() == row.timeUs()).count())
            .max()
            .orElse(0);
    assertTrue(mostAtATime <= 10, mostAtATime + " clusters");
    assertTrue(nsPerEvent < 1000, nsPerEvent + " ns an event");
  }
}
