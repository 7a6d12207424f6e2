package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Settings that users of the original know, on things of known form and motion. */
class OriginalSettingsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final BlobPath STILL = new BlobPath(40, 64, 0, 1_000_000, 6);

  private final List<ClusterTrack> rows = new ArrayList<>();
  private ClusterTracker tracker;

  private List<ClusterTrack> run(EventPacket events, String... changes) {
    rows.clear();
    tracker =
        new ClusterTracker(
            SENSOR,
            ClusterTrackerSettings.defaults().with(changes),
            timeUs -> rows.addAll(tracker.tracks()));
    tracker.track(EventPackets.copy(events));
    return rows;
  }

  @Test
  void whereThereAreManyEventsEachCountsLess() {
    EventPacket events = EventPackets.blob(SENSOR, 1, 1_000_000, STILL, 40_000, 0);
    double alike = scatter(events, "motion.mixing=per-event");
    double less = scatter(events, "motion.mixing=per-event-and-rate", "life.visibleRateHz=35");
    // A tenth of the weight, which takes the root of a tenth of the scatter.
    assertEquals(Math.sqrt(0.1), less / alike, 0.1);
  }

  /** How far the centre of what stands still wanders, root of the mean square, pixels. */
  private double scatter(EventPacket events, String... changes) {
    List<String> all = new ArrayList<>(List.of(changes));
    all.addAll(List.of("motion.mixingFactor=0.2", "motion.predict=false", "events.edges=false"));
    return Math.sqrt(
        run(events, all.toArray(String[]::new)).stream()
            .filter(row -> row.timeUs() > 200_000)
            .mapToDouble(row -> (row.yPx() - 64) * (row.yPx() - 64))
            .average()
            .orElseThrow());
  }

  @Test
  void whatIsBornBeginsWithTheVelocityOfItsEventsIfItIsToldTo() {
    double zero = 0;
    double events = 0;
    for (int seed = 0; seed < 20; seed++) {
      // 628 px/s upwards at first.
      BlobPath circle = new BlobPath(64, 64, 50, 500_000, 3);
      EventPacket first = EventPackets.blob(SENSOR, 100 + seed, 100_000, circle, 1_000, 0);
      zero += firstVelocity(first, "motion.velocity.start=zero");
      events += firstVelocity(first, "motion.velocity.start=events");
    }
    assertTrue(zero / 20 < 200, "from none: " + zero / 20);
    assertEquals(628, events / 20, 200);
  }

  private double firstVelocity(EventPacket events, String start) {
    String slowly = "motion.velocity.timeUs=100000";
    return run(events, start, "motion.mixing=per-event", slowly).get(0).vyPxPerS();
  }

  @Test
  void nothingIsFasterThanItsNeighboursIfItIsToldSo() {
    BlobPath fast = new BlobPath(64, 64, 40, 1_000_000, 5);
    EventPacket events =
        ClusterTrackerFilterTest.merged(
            EventPackets.blob(SENSOR, 3, 400_000, fast, 20_000, 0),
            EventPackets.blob(SENSOR, 4, 400_000, STILL, 20_000, 0));
    assertEquals(251, fastest(events, "motion.velocity.neighbourRadii=0"), 60);
    assertTrue(fastest(events, "motion.velocity.neighbourRadii=10") < 100);
    assertEquals(251, fastest(events, "motion.velocity.neighbourRadii=1"), 60);
  }

  private double fastest(EventPacket events, String limit) {
    return run(events, limit).stream()
        .filter(row -> row.timeUs() == 300_000)
        .mapToDouble(row -> Math.hypot(row.vxPxPerS(), row.vyPxPerS()))
        .max()
        .orElseThrow();
  }

  @Test
  void onlyEventsAtTheEdgeMoveAClusterIfItIsToldSo() {
    SplittableRandom random = new SplittableRandom(5);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 500_000; timeUs += 100) {
      // A ring of 12 px, with a spot within it that makes as many events.
      boolean ofRing = random.nextBoolean();
      double angle = random.nextDouble(2 * Math.PI);
      double distance = ofRing ? 12 : 2;
      double x = (ofRing ? 64 : 69) + distance * Math.cos(angle);
      double y = 64 + distance * Math.sin(angle);
      events.append(timeUs, (int) Math.round(x), (int) Math.round(y), random.nextBoolean());
    }
    String[] fixed = {"growth.size=false", "form.size=0.12", "events.edges=false"};
    ClusterTrack all = last(events, fixed);
    ClusterTrack edge = last(events, fixed[0], fixed[1], fixed[2], "events.edgeThickness=0.35");
    assertTrue(all.xPx() > 65.5, "with the spot: " + all);
    assertEquals(64, edge.xPx(), 0.7);
    assertEquals(500, edge.mass(), 50, "events within count as well");
  }

  private ClusterTrack last(EventPacket events, String... changes) {
    run(events, changes);
    return rows.get(rows.size() - 1);
  }
}
