package haltere.filters.cluster;

import static haltere.filters.cluster.ClusterRun.SENSOR;
import static haltere.filters.cluster.ClusterRun.pixel;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Defects of the trackers of 2007 and later that this one does not have. */
class OriginalDefectsTest {
  private static final BlobPath STILL = new BlobPath(64, 64, 0, 1_000_000, 6);

  @Test
  void rateEqualsTheTrueRate() {
    ClusterTrack last =
        new ClusterRun().take(EventPackets.blob(SENSOR, 3, 1_000_000, STILL, 20_000, 0)).last();
    assertEquals(20_000, last.rateHz(), 1000);
    assertEquals(20_000 * 0.05, last.mass(), 50);
  }

  @Test
  void rateDoesNotDependOnTheUpdateInterval() {
    EventPacket events = EventPackets.blob(SENSOR, 4, 1_000_000, STILL, 20_000, 0);
    for (String interval : List.of("200", "1000", "50000")) {
      ClusterTrack last =
          new ClusterRun("output.updateIntervalUs=" + interval).take(events).at(950_000).get(0);
      assertEquals(20_000, last.rateHz(), 1500, interval + " us");
    }
  }

  @Test
  void simultaneousEventsCountFully() {
    EventPacket together = new EventPacket(0);
    for (long timeUs = 0; timeUs <= 200_000; timeUs += 1000) {
      for (int i = 0; i < 10; i++) {
        together.append(timeUs, 64, 64, true);
      }
    }
    ClusterRun run = new ClusterRun().take(together);
    assertEquals(10_000 * 0.05, run.last().mass(), 25);
    EventPacket moving = pixel(60, 60, 0, 20_000, 100);
    for (int i = 0; i < 40; i++) {
      moving.append(20_000, 64, 60, true);
    }
    moving.append(30_000, 64, 60, true);
    moving.append(30_001, 64, 60, true);
    ClusterTrack after = new ClusterRun("motion.predict=false").take(moving).at(30_000).get(0);
    assertEquals(60 + 4 * (1 - Math.pow(0.95, 40)), after.xPx(), 1e-9);
  }

  @Test
  void longGapMakesNoRateNegative() {
    EventPacket events = pixel(64, 64, 0, 200_000, 100);
    events.append(pixel(64, 64, 500_000, 700_000, 100), 0, 2000);
    ClusterRun run = new ClusterRun("life.lifetimeUs=1000000").take(events);
    assertTrue(run.rows.stream().allMatch(row -> row.rateHz() >= 0 && row.mass() >= 0));
    assertEquals(10_000, run.last().rateHz(), 600);
  }

  @Test
  void frictionHasItsUnit() {
    EventPacket events = EventPackets.blob(SENSOR, 5, 500_000, circle(), 20_000, 0);
    double free = speed(events, "motion.frictionTimeUs=0");
    double slowed = speed(events, "motion.frictionTimeUs=20000");
    // The loop gain holds against a friction of a fifth of the averaging time: v = u τf / (τf + τ).
    assertTrue(slowed < 0.6 * free, slowed + " of " + free);
  }

  private static BlobPath circle() {
    return new BlobPath(64, 64, 30, 1_000_000, 6);
  }

  private static double speed(EventPacket events, String friction) {
    ClusterTrack last = new ClusterRun(friction, "motion.mixingFactor=0.002").take(events).last();
    return Math.hypot(last.vxPxS(), last.vyPxS());
  }

  @Test
  void eventIsAssignedToTheNearestClusterNotToThatOfItsCell() {
    // Centres 8 px apart, boxes of 7.68 px: the event in the middle of the second is in both.
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 100_000; timeUs += 200) {
      events.append(timeUs, 60, 64, true);
      events.append(timeUs, 68, 64, true);
    }
    ClusterRun run = new ClusterRun("merging.allowed=false").take(events);
    assertEquals(Set.of(1, 2), run.identities());
    assertEquals(60, run.at(90_000).get(0).xPx(), 1e-9);
    assertEquals(68, run.at(90_000).get(1).xPx(), 1e-9);
  }

  @Test
  void clustersThatMoveFarBetweenUpdatesKeepTheirPosition() {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 90_000; timeUs += 10) {
      // 1000 px/s: ten pixels from one update to the next.
      events.append(timeUs, 20 + (int) (timeUs / 1000), 64, true);
    }
    ClusterRun run =
        new ClusterRun(
                "output.updateIntervalUs=10000", "motion.mixingFactor=0.2", "motion.predict=false")
            .take(events);
    assertEquals(Set.of(1), run.identities());
    assertEquals(99, run.at(80_000).get(0).xPx(), 2);
  }

  @Test
  void rotatedBoxesContainPointsAlongTheirAxis() {
    String[] slender = {
      "shape.size=0.1", "shape.aspect=0.1", "shape.angleDeg=45", "merging.allowed=false"
    };
    EventPacket along = crowd(20, 20);
    EventPacket across = crowd(20, -20);
    // Half axes of 40 and 4 px along a diagonal: the far pixel is inside on one diagonal only.
    assertEquals(1, new ClusterRun(slender).take(along).at(90_000).size());
    assertEquals(2, new ClusterRun(slender).take(across).at(90_000).size());
  }

  private static EventPacket crowd(int dx, int dy) {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 100_000; timeUs += 100) {
      events.append(timeUs, 60, 64, true);
      if (timeUs % 200 == 0 && timeUs > 30_000) {
        events.append(timeUs, 60 + dx, 64 + dy, true);
      }
    }
    return events;
  }

  @Test
  void adaptedAspectAppliesToTheHalfAxesAtOnce() {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 200_000; timeUs += 50) {
      events.append(timeUs, 58 + (int) (timeUs / 50 % 13), 64, true);
    }
    ClusterTrack row =
        new ClusterRun("growth.aspect=true", "motion.mixingFactor=0.01").take(events).last();
    assertEquals(2.5, row.aspect(), 1e-9);
    assertEquals(7.68 * Math.sqrt(2.5), row.ellipse().majorPx(), 1e-9);
  }

  @Test
  void newClusterDoesNotInheritTheAngleOfAnother() {
    EventPacket diagonal = new EventPacket(0);
    for (long timeUs = 0; timeUs < 300_000; timeUs += 50) {
      int k = (int) (timeUs / 50 % 9) - 4;
      diagonal.append(timeUs, 40 + k, 40 + k, true);
    }
    EventPacket events = ClusterRun.merged(diagonal, pixel(100, 100, 200_000, 300_000, 100));
    ClusterRun run = new ClusterRun("shape.angle=of-events", "shape.angleDeg=10").take(events);
    ClusterTrack born = run.rows.stream().filter(row -> row.id() == 2).findFirst().orElseThrow();
    assertTrue(born.ageUs() < 15_000, born.toString());
    assertEquals(Math.toRadians(10), born.angleRad(), 1e-9);
    assertEquals(Math.PI / 4, run.at(290_000).get(0).angleRad(), 0.1);
  }

  @Test
  void eventFarFromAllClustersIsHandledWithEdgeThickness() {
    EventPacket events = EventPackets.blob(SENSOR, 6, 200_000, STILL, 10_000, 1);
    ClusterRun run = new ClusterRun("events.edgeThickness=0.3", "output.maxClusters=1");
    run.take(events);
    assertTrue(run.tracker.count() <= 1);
  }

  @Test
  void birthDoesNotShortenThePredictionOfOthers() {
    EventPacket alone = EventPackets.blob(SENSOR, 7, 400_000, circle(), 20_000, 0);
    EventPacket noise = new EventPacket(0);
    for (long timeUs = 500; timeUs < 400_000; timeUs += 1000) {
      noise.append(timeUs, 4, 4, true);
      noise.append(timeUs, 124, 124, true);
    }
    List<ClusterTrack> undisturbed = new ClusterRun().take(alone).rows;
    List<ClusterTrack> disturbed =
        new ClusterRun("life.lifetimeUs=1000")
            .take(ClusterRun.merged(alone, noise)).rows.stream()
                .filter(row -> row.xPx() > 20 && row.xPx() < 110)
                .toList();
    assertEquals(undisturbed.size(), disturbed.size(), 3);
    assertEquals(
        undisturbed.get(undisturbed.size() - 1).xPx(),
        disturbed.get(disturbed.size() - 1).xPx(),
        1e-9);
  }

  @Test
  void resetClearsVisibleClusters() {
    ClusterRun run = new ClusterRun().take(EventPackets.blob(SENSOR, 8, 200_000, STILL, 20_000, 0));
    run.tracker.reset();
    assertEquals(List.of(), run.tracker.tracks(200_000));
    run.rows.clear();
    run.take(pixel(2, 2, 0, 1000, 500));
    assertEquals(List.of(), run.rows);
  }
}
