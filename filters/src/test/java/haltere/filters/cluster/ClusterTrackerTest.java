package haltere.filters.cluster;

import static haltere.filters.cluster.ClusterRun.SENSOR;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Effects of settings on blobs of known position, size and motion. */
class ClusterTrackerTest {
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 30, 1_000_000, 6);
  private static final BlobPath STILL = new BlobPath(64, 64, 0, 1_000_000, 6);

  private static EventPacket blob(long seed, BlobPath path, long durationUs) {
    return EventPackets.blob(SENSOR, seed, durationUs, path, 20_000, 0);
  }

  /** A blob of even density in a rotated rectangle. */
  private static EventPacket rectangle(double along, double across, double angleRad) {
    SplittableRandom random = new SplittableRandom(5);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 500_000; timeUs += 20) {
      double u = random.nextDouble(-along, along);
      double w = random.nextDouble(-across, across);
      events.append(
          timeUs,
          (int) Math.round(64 + Math.cos(angleRad) * u - Math.sin(angleRad) * w),
          (int) Math.round(64 + Math.sin(angleRad) * u + Math.cos(angleRad) * w),
          true);
    }
    return events;
  }

  // Location and velocity.

  @Test
  void eventMovesItsClusterByTheMixingFactor() {
    EventPacket events = ClusterRun.pixel(60, 60, 0, 20_000, 100);
    events.append(20_000, 64, 60, true);
    events.append(20_100, 64, 60, true);
    events.append(30_000, 0, 0, true);
    ClusterTrack at =
        new ClusterRun("motion.mixingFactor=0.25", "motion.predict=false")
            .take(events)
            .at(30_000)
            .get(0);
    assertEquals(60 + 4 * (1 - 0.75 * 0.75), at.xPx(), 1e-9);
    assertEquals(60, at.yPx());
  }

  @Test
  void weightPerTimeDoesNotDependOnTheEventRate() {
    for (long stepUs : new long[] {50, 500}) {
      EventPacket events = ClusterRun.pixel(60, 60, 0, 400_000, stepUs);
      long steps = 20_000 / stepUs;
      for (int i = 0; i < steps; i++) {
        events.append(400_000 + i * stepUs, 64, 60, true);
      }
      events.append(420_000, 0, 0, true);
      events.append(420_001, 0, 0, true);
      ClusterTrack after =
          new ClusterRun(
                  "motion.weight=per-time",
                  "motion.mixingTimeUs=20000",
                  "motion.predict=false",
                  "life.visibleMass=2")
              .take(events)
              .at(420_000)
              .get(0);
      assertEquals(60 + 4 * (1 - Math.exp(-1)), after.xPx(), 0.06, "a step of " + stepUs + " us");
    }
  }

  @Test
  void eventsAboveTheVisibleRateCountLessOnRequest() {
    EventPacket events = EventPackets.blob(SENSOR, 1, 1_000_000, STILL, 40_000, 0);
    double alike = scatter(events, "motion.weight=per-event");
    // 40 kHz on a box of 15.36 px are 170 Hz a pixel: a tenth of the weight, root of the scatter.
    double less = scatter(events, "motion.weight=per-event-and-rate", "life.visibleRateHz=17");
    assertEquals(Math.sqrt(0.1), less / alike, 0.1);
  }

  /** RMS deviation of the position of a stationary blob, pixels. */
  private static double scatter(EventPacket events, String... changes) {
    String[] all = java.util.Arrays.copyOf(changes, changes.length + 2);
    all[changes.length] = "motion.mixingFactor=0.2";
    all[changes.length + 1] = "motion.predict=false";
    return Math.sqrt(
        new ClusterRun(all)
            .take(events).after(200_000).stream()
                .mapToDouble(row -> (row.yPx() - 64) * (row.yPx() - 64))
                .average()
                .orElseThrow());
  }

  @Test
  void predictedClusterIsAheadOfAnUnpredictedOne() {
    BlobPath fast = new BlobPath(64, -1000, 1064, 26_740_000, 4);
    // 250 px/s to the left at the top of a large circle, with few events.
    EventPacket events = EventPackets.blob(SENSOR, 6, 27_000_000, fast, 3_000, 0);
    assertTrue(
        lag(events, fast, "motion.predict=true") < 0.5 * lag(events, fast, "motion.predict=false"));
  }

  private static double lag(EventPacket events, BlobPath path, String predict) {
    return new ClusterRun(predict, "motion.mixingFactor=0.02")
        .take(events).rows.stream()
            .filter(row -> row.ageUs() > 300_000)
            .mapToDouble(
                row ->
                    Math.hypot(row.xPx() - path.x(row.timeUs()), row.yPx() - path.y(row.timeUs())))
            .average()
            .orElseThrow();
  }

  @Test
  void newClustersHaveTheMeanVelocityOnRequest() {
    BlobPath first = new BlobPath(40, 40, 20, 500_000, 4);
    EventPacket events =
        ClusterRun.merged(
            EventPackets.blob(SENSOR, 7, 300_000, first, 20_000, 0),
            ClusterRun.pixel(100, 100, 250_000, 260_001, 400));
    double speed = 2 * Math.PI * 20 / 0.5;
    assertTrue(newbornSpeed(events, "motion.startVelocity=zero") < 1);
    assertTrue(newbornSpeed(events, "motion.startVelocity=mean") > 0.3 * speed);
  }

  private static double newbornSpeed(EventPacket events, String start) {
    ClusterTrack born =
        new ClusterRun(start, "motion.predict=false").take(events).at(260_000).get(1);
    return Math.hypot(born.vxPxS(), born.vyPxS());
  }

  @Test
  void clusterSpeedIsLimitedByNeighboursOnRequest() {
    EventPacket events =
        ClusterRun.merged(
            blob(8, new BlobPath(64, 64, 40, 1_000_000, 5), 400_000),
            blob(9, new BlobPath(40, 64, 0, 1, 4), 400_000));
    assertEquals(251, fastest(events, "motion.neighbourRadii=0"), 75);
    assertTrue(fastest(events, "motion.neighbourRadii=10") < 100);
    assertEquals(251, fastest(events, "motion.neighbourRadii=1"), 75);
  }

  private static double fastest(EventPacket events, String limit) {
    return new ClusterRun(limit, "shape.size=0.04")
        .take(events).at(300_000).stream()
            .mapToDouble(row -> Math.hypot(row.vxPxS(), row.vyPxS()))
            .max()
            .orElseThrow();
  }

  // Shape.

  @Test
  void initialShapeFollowsTheSettings() {
    ClusterTrack row =
        new ClusterRun("shape.size=0.1", "shape.aspect=4", "shape.angleDeg=30")
            .take(blob(10, STILL, 100_000))
            .last();
    assertEquals(12.8, row.radiusPx(), 1e-9);
    assertEquals(Math.toRadians(30), row.angleRad(), 1e-9);
    // Height over width is 4: the half axis at the angle is the shorter one.
    assertEquals(6.4, row.ellipse().majorPx(), 1e-9);
    assertEquals(25.6, row.ellipse().minorPx(), 1e-9);
  }

  @Test
  void sizeAdaptsToTheSpreadOfEventsWithinItsLimits() {
    for (String type : List.of("box", "ellipse")) {
      EventPacket disc = blob(11, new BlobPath(64, 64, 0, 1, 11), 500_000);
      String[] growing = {"growth.size=true", "shape.type=" + type, "motion.mixingFactor=0.01"};
      double radius = new ClusterRun(growing).take(disc).last().radiusPx();
      // A disc of 11 px has a standard deviation of half of that along each axis.
      assertEquals(type.equals("box") ? 11 * Math.sqrt(3) / 2 : 11, radius, 0.7, type);
    }
    EventPacket large = rectangle(60, 60, 0);
    assertEquals(
        2 * 7.68,
        new ClusterRun("growth.size=true", "growth.maxScale=2").take(large).last().radiusPx(),
        1e-9);
  }

  @Test
  void aspectAndAngleAdaptToTheEvents() {
    ClusterTrack row =
        new ClusterRun(
                "growth.size=true",
                "growth.aspect=true",
                "growth.maxScale=4",
                "shape.size=0.12",
                "shape.angle=of-events",
                "motion.mixingFactor=0.005")
            .take(rectangle(20, 10, 0.6))
            .last();
    assertEquals(0.6, row.angleRad(), 0.1);
    assertEquals(2, row.aspect(), 0.2);
    // The root of the mean of both squared half sides, and half axes of that product.
    assertEquals(Math.sqrt(250), row.radiusPx(), 1);
  }

  @Test
  void angleFollowsTheVelocityOnRequest() {
    ClusterRun run = new ClusterRun("shape.angle=of-velocity").take(blob(12, CIRCLE, 600_000));
    assertTrue(run.after(200_000).size() > 30);
    for (ClusterTrack row : run.after(200_000)) {
      double off = row.angleRad() - Math.atan2(row.vyPxS(), row.vxPxS());
      assertEquals(0, Math.sin(off), 0.15);
    }
  }

  @Test
  void clustersAreSmallerNearTheVanishingPoint() {
    String[] perspective = {
      "perspective.enabled=true", "perspective.vanishingX=0.5", "perspective.minScale=0.2"
    };
    ClusterRun near = new ClusterRun(perspective).take(blob(13, at(64, 20), 50_000));
    ClusterRun far = new ClusterRun(perspective).take(blob(13, at(64, 80), 50_000));
    ClusterRun farthest = new ClusterRun(perspective).take(blob(13, at(64, 123), 50_000));
    assertEquals(7.68 * 107 / 128, near.last().radiusPx(), 0.1);
    assertEquals(7.68 * 47 / 128, far.last().radiusPx(), 0.3);
    assertEquals(7.68 * 0.2, farthest.last().radiusPx(), 1e-9);
  }

  private static BlobPath at(double x, double y) {
    return new BlobPath(x, y, 0, 1, 1);
  }

  // Life.

  @Test
  void clusterIsVisibleByMassOrByPixelRate() {
    // A mass of 50 at 1000 events a second, and 4.2 Hz a pixel of a box of 15.36 px.
    EventPacket events = ClusterRun.pixel(64, 64, 0, 1_000_000, 1000);
    String patient = "life.lifetimeUs=10000000";
    assertEquals(1, new ClusterRun("life.visibleMass=45", patient).take(events).last().id());
    assertEquals(0, new ClusterRun("life.visibleMass=55", patient).take(events).rows.size());
    String rate = "life.supportedBy=rate";
    assertEquals(
        1, new ClusterRun(rate, patient, "life.visibleRateHz=4").take(events).identities().size());
    assertEquals(
        0, new ClusterRun(rate, patient, "life.visibleRateHz=4.5").take(events).rows.size());
    assertEquals(
        0, new ClusterRun("life.minSpeedPxS=50").take(blob(14, STILL, 300_000)).rows.size());
    assertEquals(
        1,
        new ClusterRun("life.minSpeedPxS=50").take(blob(14, CIRCLE, 300_000)).identities().size());
  }

  @Test
  void unsupportedNewClustersExpireAndFreeTheirSlot() {
    EventPacket noise = new EventPacket(0);
    for (int i = 0; i < 10; i++) {
      noise.append(0, 10 + 32 * (i % 4), 50 + 32 * (i / 4), true);
    }
    EventPacket events = ClusterRun.merged(noise, ClusterRun.pixel(64, 20, 100, 100_000, 100));
    ClusterRun run = new ClusterRun("output.maxClusters=10").take(events);
    assertEquals(Set.of(1), run.identities());
    // The object starts after the lifetime of the noise.
    assertEquals(21_000, run.last().timeUs() - run.last().ageUs(), 1_100);
  }

  @Test
  void clusterExpiresAtTheBorderAsConfigured() {
    EventPacket events = blob(15, new BlobPath(5, 64, 0, 1, 3), 100_000);
    assertTrue(new ClusterRun("life.border=centre").take(events).rows.size() > 5);
    assertTrue(new ClusterRun("life.border=never").take(events).rows.size() > 5);
    assertEquals(0, new ClusterRun("life.border=outline").take(events).rows.size());
    BlobPath leaving = new BlobPath(64, 64, 80, 2_000_000, 3);
    EventPacket gone = blob(16, leaving, 600_000);
    gone.append(700_000, 64, 64, true);
    gone.append(760_000, 64, 64, true);
    ClusterRun run = new ClusterRun("life.border=centre", "motion.mixingFactor=0.2").take(gone);
    assertTrue(run.rows.stream().allMatch(row -> row.yPx() <= 127.5), "outside the sensor");
  }

  @Test
  void surroundEventsReduceMassOnRequest() {
    EventPacket events = rectangle(14, 4, 0);
    String[] growing = {"growth.size=true", "growth.maxScale=1", "motion.mixingFactor=0.001"};
    double free = new ClusterRun(growing).take(events).last().mass();
    ClusterRun inhibited =
        new ClusterRun(growing[0], growing[1], growing[2], "events.inhibition=0.5").take(events);
    // Of 28 columns 15 are within 7.68 px; the others take half an event away.
    assertEquals((15 - 0.5 * 13) / 28, inhibited.last().mass() / free, 0.03);
  }

  @Test
  void onlyEdgeEventsMoveAClusterOnRequest() {
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
    String[] circle = {"shape.size=0.12", "shape.type=ellipse", "motion.mixingFactor=0.005"};
    ClusterTrack all = new ClusterRun(circle).take(events).last();
    ClusterRun edge = new ClusterRun(circle[0], circle[1], circle[2], "events.edgeThickness=0.35");
    assertTrue(all.xPx() > 65.5, "with the spot: " + all);
    assertEquals(64, edge.take(events).last().xPx(), 1);
    assertEquals(500, edge.last().mass(), 50, "events within count as well");
  }

  @Test
  void eventsOfTheOtherPolarityAreIgnored() {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 100_000; timeUs += 100) {
      events.append(timeUs, 40, 40, true);
      events.append(timeUs, 90, 90, false);
    }
    assertEquals(2, new ClusterRun().take(events).at(90_000).size());
    assertEquals(
        40, new ClusterRun("events.polarity=on").take(events).at(90_000).get(0).xPx(), 1e-9);
    List<ClusterTrack> off = new ClusterRun("events.polarity=off").take(events).at(90_000);
    assertEquals(1, off.size());
    assertEquals(90, off.get(0).xPx(), 1e-9);
  }

  @Test
  void numberOfClustersIsLimited() {
    EventPacket events = EventPackets.uniform(SENSOR, 17, 200_000, 0, 2);
    ClusterRun run = new ClusterRun("output.maxClusters=7", "shape.size=0.02").take(events);
    assertTrue(run.tracker.count() <= 7);
    assertTrue(run.rows.size() > 100, "some are visible: " + run.rows.size());
  }

  // Bad input.

  @Test
  void gapOfAnHourRemovesClustersAndReusesNoIdentity() {
    EventPacket events = blob(18, CIRCLE, 300_000);
    events.append(EventPackets.shifted(blob(19, CIRCLE, 300_000), 3_600_000_000L), 0, 5000);
    ClusterRun run = new ClusterRun().take(events);
    assertEquals(Set.of(1, 2), run.identities());
    for (ClusterTrack row : run.rows) {
      boolean early = row.timeUs() < 1_000_000;
      assertTrue(early || row.timeUs() >= 3_600_000_000L, "in the gap: " + row);
      assertEquals(early ? 1 : 2, row.id());
    }
  }

  @Test
  void simultaneousOrSinglePixelEventsFormAtMostOneCluster() {
    EventPacket atOnce = new EventPacket(1_000_000);
    for (int i = 0; i < 1_000_000; i++) {
      atOnce.append(5, 64, 64, true);
    }
    atOnce.append(40_000, 64, 64, true);
    ClusterRun run = new ClusterRun().take(atOnce);
    assertEquals(Set.of(1), run.identities());
    assertEquals(64, run.last().xPx(), 1e-9);
    assertEquals(0, run.last().vxPxS(), 1e-9);
  }

  @Test
  void noiseOnALargeSensorStaysWithinTheLimits() {
    SensorGeometry large = new SensorGeometry(1280, 720);
    EventPacket noise = EventPackets.uniform(large, 20, 500_000, 0, 0.2);
    ClusterRun run = new ClusterRun(large, "output.maxClusters=200", "shape.size=0.02");
    run.take(noise);
    assertTrue(run.tracker.count() <= 200);
    run.tracker.reset();
    assertEquals(0, run.tracker.count());
  }
}
