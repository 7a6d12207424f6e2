package haltere.filters.cluster;

import static haltere.filters.cluster.ClusterRun.SENSOR;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ClusterMergingTest {
  /** A blob that stands still, and a lighter one that comes nearer and stays. */
  private static EventPacket meeting() {
    SplittableRandom random = new SplittableRandom(20);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 2_000_000; timeUs += 50) {
      events.append(timeUs, 64 + random.nextInt(-4, 5), 64 + random.nextInt(-4, 5), true);
      if (timeUs % 100 == 0) {
        int x = Math.max(70, 110 - (int) (timeUs / 25_000));
        events.append(timeUs, x + random.nextInt(-4, 5), 64 + random.nextInt(-4, 5), true);
      }
    }
    return events;
  }

  /** Two blobs that move through each other at 75 px/s, side by side by 2 px. */
  private static EventPacket crossing() {
    BlobPath left = new BlobPath(64, -2000, 2064, 2 * Math.PI * 2064 / 75 * 1e6, 3);
    // It is at the top of its large circle after a quarter of a round.
    long quarterUs = Math.round(2 * Math.PI * 2064 / 75 * 1e6 / 4);
    long halfUs = 600_000;
    return ClusterRun.merged(
        window(EventPackets.blob(SENSOR, 1, quarterUs + halfUs, left, 10_000, 0), quarterUs),
        window(
            mirrored(EventPackets.blob(SENSOR, 2, quarterUs + halfUs, left, 10_000, 0)),
            quarterUs));
  }

  private static EventPacket window(EventPacket events, long middleUs) {
    long fromUs = middleUs - 600_000;
    return EventPackets.shifted(
        EventPackets.part(events, events.indexAtOrAfter(fromUs), events.size()), -fromUs);
  }

  private static EventPacket mirrored(EventPacket events) {
    EventPacket mirrored = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      mirrored.append(events.timeUs(i), 128 - events.x(i), events.y(i) - 2, events.isOn(i));
    }
    return mirrored;
  }

  @Test
  void overlappingClustersMergeIntoTheHeavierOne() {
    ClusterRun run = new ClusterRun().take(meeting());
    assertEquals(2, run.at(100_000).size(), "two at first");
    List<ClusterTrack> end = run.at(1_990_000);
    assertEquals(1, end.size());
    ClusterTrack early =
        run.rows.stream().filter(row -> Math.abs(row.xPx() - 64) < 1).findFirst().orElseThrow();
    assertEquals(early.id(), end.get(0).id());
  }

  @Test
  void overlappingClustersStayTwoWithoutMerging() {
    assertEquals(2, new ClusterRun("merging.allowed=false").take(meeting()).at(1_990_000).size());
    assertEquals(1, new ClusterRun("merging.overlap=1").take(meeting()).at(1_400_000).size());
    assertEquals(2, new ClusterRun("merging.overlap=0.3").take(meeting()).at(1_400_000).size());
  }

  @Test
  void clustersWithDifferentDirectionsPassWithoutMerging() {
    ClusterRun different = new ClusterRun("shape.size=0.04").take(crossing());
    assertEquals(Set.of(1, 2), different.identities());
    assertEquals(2, different.at(600_000).size(), "at the same place");
    assertEquals(2, different.at(1_150_000).size());
    ClusterRun all =
        new ClusterRun("shape.size=0.04", "merging.differentAngleDeg=180").take(crossing());
    assertEquals(1, all.at(600_000).size(), "merged where they meet");
  }

  @Test
  void mergedClustersHaveTheEventsAndSizeOfBothOnRequest() {
    ClusterRun joined =
        new ClusterRun("merging.joinSize=true", "growth.maxScale=4").take(meeting());
    ClusterTrack before = joined.at(100_000).get(0);
    ClusterTrack after = joined.last();
    assertEquals(2 * before.radiusPx(), after.radiusPx(), 1e-9);
    assertTrue(after.events() > 0.95 * meeting().size(), after.toString());
    ClusterRun heavier = new ClusterRun().take(meeting());
    assertEquals(before.radiusPx(), heavier.last().radiusPx(), 1e-9);
  }

  @Test
  void mergedClusterKeepsTheVelocity() {
    // Cardinale's tracker began again with no velocity.
    SplittableRandom random = new SplittableRandom(21);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 900_000; timeUs += 50) {
      double x = 10 + 100 * timeUs * 1e-6 + random.nextDouble(-3, 3);
      events.append(timeUs, (int) Math.round(x), 64 + random.nextInt(-3, 4), true);
      double ahead = 40 + 60 * timeUs * 1e-6 + random.nextDouble(-3, 3);
      events.append(timeUs, (int) Math.round(ahead), 64 + random.nextInt(-3, 4), true);
    }
    ClusterRun run = new ClusterRun("shape.size=0.04").take(events);
    assertEquals(2, run.at(300_000).size());
    long mergedUs =
        run.after(300_000).stream()
            .filter(row -> run.at(row.timeUs()).size() == 1)
            .findFirst()
            .orElseThrow()
            .timeUs();
    double velocity = run.at(mergedUs).get(0).vxPxS();
    assertTrue(velocity > 55 && velocity < 105, velocity + " px/s at " + mergedUs);
  }
}
