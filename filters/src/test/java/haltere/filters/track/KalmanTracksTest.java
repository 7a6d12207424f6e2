package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.dots.DotTruth;
import haltere.core.simulation.internal.dots.MovingDotsScene;
import haltere.core.simulation.internal.dots.MovingDotsSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.plane.RoadMapping;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * What each option of the Kalman filter on clusters does, and slips of the original that it mends.
 */
class KalmanTracksTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 30, 1_000_000, 4);

  private final List<TrackPoint> points = new ArrayList<>();
  private final List<TrackUpdate> updates = new ArrayList<>();
  private KalmanTracks tracks;

  private void run(KalmanTracksSettings settings, EventPacket events) {
    points.clear();
    updates.clear();
    tracks = new KalmanTracks(SENSOR, settings, this::report);
    tracks.observe(() -> true, updates::add);
    tracks.track(EventPackets.copy(events));
  }

  private void report(long timeUs) {
    tracks.forEach(timeUs, track -> points.add(track.point()));
  }

  private void run(EventPacket events, String... changes) {
    run(KalmanTracksSettings.defaults().with(changes), events);
  }

  private Set<Integer> identities() {
    return points.stream().map(TrackPoint::id).collect(Collectors.toSet());
  }

  private List<TrackPoint> at(long timeUs) {
    return points.stream().filter(point -> point.timeUs() == timeUs).toList();
  }

  /** A blob of 3 px that moves to the right at a speed, hidden for a while. */
  private static EventPacket passing(
      double fromX, double y, double speedPxS, long hiddenFromUs, long hiddenToUs) {
    SplittableRandom random = new SplittableRandom((long) (1000 * fromX + y));
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 1_000_000; timeUs += 100) {
      double x = fromX + speedPxS * timeUs * 1e-6;
      if (timeUs < hiddenFromUs || timeUs >= hiddenToUs) {
        int column = (int) Math.round(x + random.nextDouble(-3, 3));
        int row = (int) Math.round(y + random.nextDouble(-3, 3));
        if (SENSOR.contains(column, row)) {
          events.append(timeUs, column, row, random.nextBoolean());
        }
      }
    }
    return events;
  }

  private static EventPacket merged(EventPacket first, EventPacket second) {
    EventPacket all = new EventPacket(0);
    int j = 0;
    for (int i = 0; i < first.size(); i++) {
      for (; j < second.size() && second.timeUs(j) < first.timeUs(i); j++) {
        all.append(second.timeUs(j), second.address(j));
      }
      all.append(first.timeUs(i), first.address(i));
    }
    all.append(second, j, second.size());
    return all;
  }

  @Test
  void trackOfABlobHasItsPositionAndVelocity() {
    run(EventPackets.blob(SENSOR, 1, 2_000_000, CIRCLE, 30_000, 0));
    assertEquals(Set.of(1), identities());
    assertTrue(points.size() > 190, points.size() + " points");
    double speed = 2 * Math.PI * 30;
    for (TrackPoint point : points) {
      if (point.timeUs() > 500_000) {
        assertEquals(CIRCLE.x(point.timeUs()), point.xPx(), 1.5, point::toString);
        assertEquals(CIRCLE.y(point.timeUs()), point.yPx(), 1.5, point::toString);
        double angle = 2 * Math.PI * point.timeUs() / 1e6;
        assertEquals(-speed * Math.sin(angle), point.vxPxS(), 0.4 * speed, point::toString);
        assertEquals(speed * Math.cos(angle), point.vyPxS(), 0.4 * speed, point::toString);
      }
    }
  }

  @Test
  void dotsOfASceneAreTrackedAtTheirTruePositions() {
    MovingDotsScene scene =
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with("dots.count=2", "noise.shotHz=0", "noise.leakHz=0", "noise.hotPixels=0"));
    EventPacket events = new EventPacket(0);
    while (events.isEmpty() || events.lastTimeUs() < 1_000_000) {
      scene.next(new Collector(events));
    }
    run(events);
    List<TrackPoint> end = at(990_000);
    for (DotTruth truth : scene.truthRows(990_000)) {
      assertTrue(
          end.stream()
              .anyMatch(
                  point -> Math.hypot(point.xPx() - truth.xPx(), point.yPx() - truth.yPx()) < 3),
          truth + " among " + end);
    }
  }

  private record Collector(EventPacket events) implements StreamHandler {
    @Override
    public void packet(EventPacket packet) {
      events.append(packet, 0, packet.size());
    }

    @Override
    public void notified(StreamNotification notification) {
      // Only the events are wanted.
    }
  }

  @Test
  void hiddenTrackCoastsAndKeepsItsIdentity() {
    EventPacket events = passing(15, 64, 90, 500_000, 850_000);
    run(events, "shape.size=0.05");
    assertEquals(Set.of(1), identities());
    TrackPoint coasting = at(800_000).get(0);
    assertEquals(15 + 90 * 0.8, coasting.xPx(), 12);
    assertTrue(coasting.sdXPx() > 3 * at(400_000).get(0).sdXPx(), "P grows: " + coasting);
    assertEquals(15 + 90 * 0.98, at(980_000).get(0).xPx(), 3);
    run(events, "shape.size=0.05", "coastTimeS=0.02");
    assertEquals(Set.of(1, 2), identities());
    assertEquals(List.of(), at(800_000));
  }

  @Test
  void newClustersAreAssignedToCoastingTracksJointly() {
    // Two side by side, 14 px apart, are hidden together; nearest first could exchange them.
    EventPacket events =
        merged(passing(15, 50, 90, 500_000, 700_000), passing(8, 64, 90, 500_000, 700_000));
    run(events, "shape.size=0.04", "gateSigmas=10");
    assertEquals(Set.of(1, 2), identities());
    int upper = at(450_000).stream().filter(p -> p.yPx() > 57).findFirst().orElseThrow().id();
    assertEquals(
        upper, at(950_000).stream().filter(p -> p.yPx() > 57).findFirst().orElseThrow().id());
  }

  @Test
  void clusterOutsideTheGateStartsANewTrack() {
    EventPacket events =
        merged(passing(15, 30, 60, 300_000, 1_000_000), passing(15, 100, 60, 0, 350_000));
    run(events, "shape.size=0.04", "coastTimeS=0.5");
    assertEquals(Set.of(1, 2), identities());
  }

  @Test
  void tracksEndOutsideThePicture() {
    EventPacket events = passing(60, 64, 120, 1_000_000, 1_000_000);
    events.append(1_200_000, 5, 5, true);
    run(events, "shape.size=0.04", "coastTimeS=10");
    assertTrue(points.stream().allMatch(point -> point.xPx() <= 127.5));
    assertTrue(points.get(points.size() - 1).timeUs() < 700_000, "after it has left");
  }

  @Test
  void trackIsUpdatedOnceItsClusterHasEnoughEvents() {
    // 10,000 and 2,500 events a second.
    EventPacket events = twoRates();
    run(events, "eventsTillTrack=100", "trackIntervalUs=1000");
    assertEquals(100, perSecond(30), 10);
    assertEquals(25, perSecond(90), 3);
  }

  @Test
  void allTracksAreUpdatedOnceAllClustersHaveEnoughEvents() {
    run(twoRates(), "eventsTillTrack=125", "trackIntervalUs=1000", "eventsOf=all-clusters");
    assertEquals(100, perSecond(30), 10);
    assertEquals(perSecond(30), perSecond(90), 1);
  }

  private static EventPacket twoRates() {
    EventPacket events = new EventPacket(0);
    SplittableRandom random = new SplittableRandom(3);
    for (long timeUs = 0; timeUs < 1_000_000; timeUs += 100) {
      events.append(timeUs, 30 + random.nextInt(-2, 3), 64 + random.nextInt(-2, 3), true);
      if (timeUs % 400 == 0) {
        events.append(timeUs, 90 + random.nextInt(-2, 3), 64 + random.nextInt(-2, 3), true);
      }
    }
    return events;
  }

  private long perSecond(double x) {
    return updates.stream().filter(update -> Math.abs(update.x() - x) < 5).count();
  }

  @Test
  void dynamicVariancesApproachTheirFinalValuesExponentially() {
    EventPacket events = EventPackets.blob(SENSOR, 4, 1_000_000, CIRCLE, 30_000, 0);
    run(
        events,
        "dynamicVariances=true",
        "filter.varianceMixingFactor=0.1",
        "maxMeasurementVariance=8",
        "noise=per-update",
        "minProcessVariance=2");
    for (int n = 0; n < 40; n++) {
      double youth = Math.pow(0.9, n + 1);
      assertEquals(8 - 7 * youth, updates.get(n).rPx2(), 1e-9);
      // The original's q crossed its end, for its sign is wrong there.
      assertEquals(2 * (1 + 9 * youth), updates.get(n).qVxvx(), 1e-9);
      assertEquals(updates.get(n).qXx(), updates.get(n).qVxvx());
    }
    run(events, "dynamicVariances=false", "maxMeasurementVariance=8");
    assertTrue(updates.stream().allMatch(update -> update.rPx2() == 8));
  }

  @Test
  void bothAxesHaveProcessNoise() {
    // In the original the first axis has none: it follows turns ever more slowly.
    run(EventPackets.blob(SENSOR, 5, 3_000_000, CIRCLE, 30_000, 0));
    TrackUpdate last = updates.get(updates.size() - 1);
    assertEquals(last.gainX(), last.gainY(), 1e-9);
    assertEquals(last.pVxvx(), last.pVyvy(), 1e-6);
    assertEquals(CIRCLE.x(2_990_000), at(2_990_000).get(0).xPx(), 1.5);
    assertEquals(CIRCLE.y(2_990_000), at(2_990_000).get(0).yPx(), 1.5);
  }

  @Test
  void densityNoiseIsIndependentOfTheUpdateRateAndNoisePerUpdateIsNot() {
    EventPacket events = EventPackets.blob(SENSOR, 6, 2_205_000, CIRCLE, 30_000, 0);
    double[] density = new double[2];
    double[] perUpdate = new double[2];
    String[] intervals = {"trackIntervalUs=2000", "trackIntervalUs=20000"};
    for (int i = 0; i < 2; i++) {
      run(events, intervals[i], "noise=density", "minProcessVariance=1000");
      density[i] = addedPerSecond();
      run(events, intervals[i], "noise=per-update", "minProcessVariance=1000");
      perUpdate[i] = addedPerSecond();
    }
    assertEquals(1, density[0] / density[1], 0.05);
    assertEquals(10, perUpdate[0] / perUpdate[1], 0.5);
  }

  private double addedPerSecond() {
    return updates.stream()
        .filter(update -> update.timeUs() > 200_000)
        .mapToDouble(TrackUpdate::qVxvx)
        .sum();
  }

  @Test
  void noiseOfAStepMatchesItsDuration() {
    run(EventPackets.blob(SENSOR, 7, 300_000, CIRCLE, 30_000, 0), "minProcessVariance=300");
    TrackUpdate update = updates.get(5);
    assertEquals(300 * 0.01, update.qVxvx(), 1e-9);
    assertEquals(300 * 1e-4 / 2, update.qXvx(), 1e-9);
    assertEquals(300 * 1e-6 / 3, update.qXx(), 1e-9);
  }

  @Test
  void feedbackMovesTheClusterToTheEstimate() {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 500_000; timeUs += 100) {
      events.append(timeUs, timeUs < 200_000 ? 60 : 64, 64, true);
    }
    run(
        events,
        "maxMeasurementVariance=100",
        "motion.mixingFactor=0.001",
        "motion.predict=false",
        "feedbackToCluster=true");
    for (int n = 30; n < updates.size(); n++) {
      // A hundred events have moved the cluster from the estimate before.
      double before = updates.get(n - 1).x();
      double moved = before + (64 - before) * (1 - Math.pow(0.999, 100));
      assertEquals(moved, updates.get(n).measuredX(), 1e-6);
      assertTrue(Math.abs(64 - before) > 0.01);
    }
  }

  @Test
  void mergedClustersLeaveNoFrozenTrack() {
    // In the original the filter of the merged cluster holds an object that no longer moves.
    EventPacket events =
        merged(passing(10, 64, 100, 1_000_000, 1_000_000), passing(40, 64, 40, 600_000, 1_000_000));
    run(events, "shape.size=0.05", "differentAngleDeg=180", "coastTimeS=0.1");
    List<TrackPoint> end = at(950_000);
    assertEquals(1, end.size(), end::toString);
    assertEquals(10 + 95, end.get(0).xPx(), 3);
  }

  @Test
  void originalPresetFollowsABlobWithRisingVariances() {
    BlobPath slow = new BlobPath(64, 64, 30, 6_000_000, 4);
    run(KalmanTracksSettings.original(), EventPackets.blob(SENSOR, 9, 2_000_000, slow, 20_000, 0));
    assertEquals(Set.of(1), identities());
    assertEquals(slow.x(1_990_000), at(1_990_000).get(0).xPx(), 4);
    assertTrue(updates.get(0).rPx2() < 1.2);
    assertTrue(updates.get(updates.size() - 1).rPx2() > 7);
    assertTrue(updates.get(0).qXx() > 9 && updates.get(updates.size() - 1).qXx() < 1.5);
  }

  @Test
  void stateOnARoadIsInMetres() {
    // A blob that stands 20 m ahead and 2 m to the right drives off at 10 m/s.
    KalmanTracksSettings settings =
        KalmanTracksSettings.defaults()
            .with("mapToRoad=true", "view.bridgeHeightM=5", "nearestM=6", "shape.size=0.03");
    RoadMapping road = new RoadMapping(settings.road().view(), SENSOR);
    SplittableRandom random = new SplittableRandom(10);
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 1_000_000; timeUs += 50) {
      double distance = 12 + 10 * timeUs * 1e-6;
      events.append(
          timeUs,
          (int) Math.round(road.pixelX(2, distance) + random.nextDouble(-1.5, 1.5)),
          (int) Math.round(road.pixelY(2, distance) + random.nextDouble(-1.5, 1.5)),
          true);
    }
    run(settings, events);
    TrackUpdate last = updates.get(updates.size() - 1);
    double distance = 12 + 10 * last.timeUs() * 1e-6;
    assertEquals(2, last.x(), 0.3);
    assertEquals(distance, last.y(), 1);
    assertEquals(10, last.vy(), 2.5);
    TrackPoint point = points.get(points.size() - 1);
    double at = 12 + 10 * point.timeUs() * 1e-6;
    assertEquals(road.pixelY(2, at), point.yPx(), 1);
    // A pixel is worth more metres farther away.
    TrackUpdate first = updates.get(10);
    assertTrue(last.pYy() > first.pYy(), first + " and " + last);
    run(settings, passing(20, 126.9, 10, 1_000_000, 1_000_000));
    assertTrue(points.stream().allMatch(p -> p.yPx() < 127), "above the vanishing point");
  }

  // Bad input.

  @Test
  void silenceOfAnHourEndsTracksAndReusesNoIdentity() {
    EventPacket events = EventPackets.blob(SENSOR, 11, 300_000, CIRCLE, 20_000, 0);
    EventPacket later =
        EventPackets.shifted(
            EventPackets.blob(SENSOR, 12, 300_000, CIRCLE, 20_000, 0), 3_600_000_000L);
    events.append(later, 0, later.size());
    run(events, "coastTimeS=60");
    assertEquals(Set.of(1, 2), identities());
    assertTrue(
        points.stream()
            .allMatch(p -> p.timeUs() < 61_000_000 || p.timeUs() >= 3_600_000_000L && p.id() == 2));
  }

  @Test
  void noiseMakesAtMostTwiceAsManyTracksAsClusters() {
    EventPacket noise = EventPackets.uniform(SENSOR, 13, 300_000, 0, 5);
    run(noise, "maxClusters=10", "shape.size=0.02", "coastTimeS=60", "visibleMass=4");
    assertTrue(points.size() > 100);
    for (long timeUs = 100_000; timeUs < 1_400_000; timeUs += 100_000) {
      assertTrue(at(timeUs).size() <= 20, at(timeUs).size() + " tracks");
    }
  }

  @Test
  void resetRemovesTracksAndRestartsNumbering() {
    EventPacket events = EventPackets.blob(SENSOR, 14, 300_000, CIRCLE, 20_000, 0);
    run(events, "eventsOf=all-clusters", "eventsTillTrack=500");
    tracks.reset();
    int reported = points.size();
    report(300_000);
    assertEquals(reported, points.size());
    int before = updates.size();
    tracks.track(EventPackets.copy(events));
    assertEquals(before, updates.size() - before, "as many updates as a new tracker makes");
    assertEquals(Set.of(1, 2), identities());
  }
}
