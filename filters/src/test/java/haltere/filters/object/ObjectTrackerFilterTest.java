package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.settings.SettingsProblem;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.filters.object.MovingShapes.Place;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.testing.EventFilterContract;
import haltere.testing.EventList;
import haltere.testing.EventPackets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;

class ObjectTrackerFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  private final List<ObjectTrack> rows = new ArrayList<>();
  private final ObjectTrackerFilter filter = subscribed();

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new ObjectTrackerFilter(geometry, ObjectTrackerSettings.defaults());
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    double middle = geometry.height() / 2.0;
    return new MovingShapes(geometry, seed)
        .noise(1)
        .box(5, 5, 20_000, s -> new Place(15 + 60 * s, middle))
        .events(1);
  }

  @Override
  protected Object withoutIdentity(Object result) {
    return result instanceof ObjectTrack track
        ? track.withId(0)
        : ((TrailSnapshot) result)
            .trails().stream()
                .map(trail -> trail.path().stream().map(this::withoutIdentity).toList())
                .toList();
  }

  private ObjectTrackerFilter subscribed(String... changes) {
    ObjectTrackerFilter made =
        new ObjectTrackerFilter(SENSOR, ObjectTrackerSettings.defaults().with(changes));
    made.tracks().subscribe(rows::add);
    return made;
  }

  private void run(MovingShapes shapes, double durationS) {
    filter.process(shapes.events(durationS));
    filter.notified(new EndOfStream(0));
  }

  private Map<Integer, List<ObjectTrack>> byIdentity() {
    Map<Integer, List<ObjectTrack>> byId = new TreeMap<>();
    rows.forEach(row -> byId.computeIfAbsent(row.id(), id -> new ArrayList<>()).add(row));
    return byId;
  }

  @Test
  void statusExplainsMissingResultsUntilAnObjectIsConfirmed() {
    EventPacket events = stream(SENSOR, 1);
    EventPacket early = new EventPacket(events.size());
    early.append(events, 0, events.indexAtOrAfter(200_000));
    EventPacket later = new EventPacket(events.size());
    later.append(events, early.size(), events.size());
    String waiting = "No objects yet: an object is confirmed after 0.3 s of motion.";
    assertEquals(waiting, filter.status());
    filter.process(early);
    assertEquals(waiting, filter.status());
    filter.process(later);
    assertEquals("", filter.status());
    filter.reset();
    assertEquals(waiting, filter.status());
  }

  private static MovingShapes shapes(long seed) {
    return new MovingShapes(SENSOR, seed).noise(0.5);
  }

  private static DoubleFunction<Place> along(double x, double y, double vx, double vy) {
    return s -> new Place(x + vx * s, y + vy * s);
  }

  @Test
  void movingBoxIsOneTrackWithItsPositionVelocityAndExtent() {
    run(shapes(1).box(8, 5, 20_000, along(20, 40, 60, 20)), 1.2);
    assertEquals(1, byIdentity().size());
    double squares = 0;
    int compared = 0;
    for (ObjectTrack row : rows) {
      if (row.ageS() < 0.4) {
        continue;
      }
      double s = row.timeUs() * 1e-6;
      assertEquals(20 + 60 * s, row.xPx(), 2);
      assertEquals(40 + 20 * s, row.yPx(), 2);
      assertEquals(60, row.vxPxS(), 3 * row.sdVxPxS());
      assertEquals(20, row.vyPxS(), 3 * row.sdVyPxS());
      squares += Math.pow(row.vxPxS() - 60, 2) + Math.pow(row.vyPxS() - 20, 2);
      compared += 2;
      assertEquals(9, row.majorPx(), 3);
      assertEquals(5, row.minorPx(), 3);
      assertTrue(row.existence() > 0.9);
    }
    assertEquals(0, Math.sqrt(squares / compared), 10);
    assertTrue(rows.size() > 100, rows.size() + " rows");
  }

  @Test
  void rowsSinceTheFirstEventsArePublishedOnConfirmation() {
    run(shapes(2).box(6, 6, 20_000, along(20, 40, 60, 0)), 1);
    assertTrue(rows.get(0).timeUs() < 150_000, rows.get(0).timeUs() + " us");
    for (int i = 1; i < rows.size(); i++) {
      assertTrue(rows.get(i).timeUs() > rows.get(i - 1).timeUs());
    }
  }

  @Test
  void noiseYieldsNoObject() {
    for (double hertz : new double[] {0.1, 2, 20}) {
      run(new MovingShapes(SENSOR, 3).noise(hertz), 2);
      assertEquals(List.of(), rows, hertz + " Hz");
      filter.reset();
    }
  }

  @Test
  void objectStoppingForTwoSecondsKeepsItsIdentity() {
    run(
        shapes(4)
            .box(
                6,
                6,
                20_000,
                s ->
                    s < 0.8
                        ? new Place(20 + 60 * s, 60)
                        : s < 2.8 ? null : new Place(68 + 60 * (s - 2.8), 60)),
        3.4);
    assertEquals(1, byIdentity().size());
    ObjectTrack last = rows.get(rows.size() - 1);
    assertEquals(68 + 60 * (last.timeUs() * 1e-6 - 2.8), last.xPx(), 3);
  }

  @Test
  void objectThatMovesInJerksIsOneTrackSinceItsFirstOne() {
    double motionS = 0.15;
    double pauseS = 0.1;
    run(
        shapes(11)
            .box(
                6,
                6,
                20_000,
                s -> {
                  double whole = Math.floor(s / (motionS + pauseS));
                  double inMotion = s - whole * (motionS + pauseS);
                  return inMotion < motionS
                      ? new Place(15 + 60 * (whole * motionS + inMotion), 60)
                      : null;
                }),
        2);
    assertEquals(1, byIdentity().size());
    assertTrue(rows.get(0).timeUs() < 150_000, rows.get(0).timeUs() + " us");
  }

  @Test
  void objectOfABriefStreamThatStopsBeforeItsEndIsReported() {
    run(
        shapes(12).box(6, 6, 20_000, s -> s < 0.25 ? new Place(20 + 60 * s, 60) : null).noise(2),
        0.3);
    assertEquals(1, byIdentity().size());
  }

  @Test
  void objectsMovingApartAreTwoTracks() {
    run(
        shapes(5).box(5, 5, 15_000, along(60, 30, -40, 0)).box(5, 5, 15_000, along(68, 90, 40, 0)),
        1);
    assertEquals(2, byIdentity().size());
  }

  @Test
  void edgesMovingTogetherAreOneTrack() {
    run(
        shapes(6).box(1, 8, 8_000, along(20, 50, 70, 0)).box(1, 8, 8_000, along(34, 50, 70, 0)),
        1.2);
    assertEquals(1, byIdentity().size());
    ObjectTrack last = rows.get(rows.size() - 1);
    assertEquals(27 + 70 * last.timeUs() * 1e-6, last.xPx(), 4);
  }

  @Test
  void edgesThatPassBesideOneAnotherAreTwoTracksAlthoughTheLineBetweenThemTurns() {
    SensorGeometry wide = new SensorGeometry(240, 128);
    int separate = 0;
    for (int seed = 0; seed < 10; seed++) {
      rows.clear();
      ObjectTrackerFilter tracker = new ObjectTrackerFilter(wide, ObjectTrackerSettings.defaults());
      tracker.tracks().subscribe(rows::add);
      tracker.process(
          new MovingShapes(wide, 200 + seed)
              .noise(0.5)
              .box(1, 8, 10_000, along(30, 40, 60, 0))
              .box(1, 8, 10_000, along(-6, 68, 96, 0))
              .events(2));
      tracker.notified(new EndOfStream(0));
      separate += byIdentity().size() == 2 ? 1 : 0;
    }
    assertTrue(separate >= 9, separate + " of 10");
  }

  @Test
  void endsOfATurningRodAreOneTrack() {
    int whole = 0;
    for (int seed = 0; seed < 10; seed++) {
      rows.clear();
      filter.reset();
      double turn = 2.5;
      run(
          shapes(300 + seed)
              .box(5, 1, 6_000, turn, s -> rodEnd(12, turn * s, s))
              .box(5, 1, 6_000, turn, s -> rodEnd(-12, turn * s, s)),
          1.6);
      whole += byIdentity().size() == 1 ? 1 : 0;
    }
    assertTrue(whole >= 9, whole + " of 10");
  }

  private static Place rodEnd(double radius, double angleRad, double s) {
    return new Place(40 + 30 * s + radius * Math.cos(angleRad), 60 + radius * Math.sin(angleRad));
  }

  @Test
  void smallComponentsMovingTogetherAreOneTrackBesideALargeObject() {
    MovingShapes shapes =
        shapes(6)
            .box(18, 18, 60_000, along(25, 108, 20, 0))
            .box(3, 3, 8_000, along(15, 28, 30, 0))
            .box(3, 3, 8_000, along(15, 4, 30, 0));
    run(shapes, 1.5);
    assertEquals(2, byIdentity().size());
  }

  @Test
  void passingObjectsKeepTheirIdentities() {
    int kept = 0;
    for (int seed = 0; seed < 10; seed++) {
      rows.clear();
      filter.reset();
      run(
          shapes(100 + seed)
              .box(5, 5, 15_000, along(15, 56, 70, 0))
              .box(5, 5, 15_000, along(113, 76, -70, 0)),
          1.4);
      boolean isKept =
          byIdentity().size() == 2
              && byIdentity().values().stream()
                  .allMatch(
                      path -> Math.abs(path.get(0).yPx() - path.get(path.size() - 1).yPx()) < 8);
      kept += isKept ? 1 : 0;
    }
    assertTrue(kept >= 9, kept + " of 10");
  }

  @Test
  void hotPixelFlickerAndFlashYieldNoObject() {
    SplittableRandom random = new SplittableRandom(7);
    EventPacket hot = new EventPacket(0);
    EventPacket lamp = new EventPacket(0);
    for (int i = 0; i < 100_000; i++) {
      hot.append(i * 20L, EventAddress.pack(40, 40, true));
      long burstUs = i / 2000 * 20_000L;
      lamp.append(burstUs, EventAddress.pack(random.nextInt(128), random.nextInt(128), i % 2 == 0));
    }
    EventPacket flash = new EventPacket(0);
    for (int i = 0; i < 1_000_000; i++) {
      flash.append(5_000, EventAddress.pack(random.nextInt(128), random.nextInt(128), true));
    }
    for (EventPacket events : List.of(hot, lamp, flash)) {
      filter.process(events);
      filter.notified(new EndOfStream(0));
      byIdentity()
          .values()
          .forEach(path -> assertTrue(path.get(path.size() - 1).ageS() < 0.5, "a false object"));
      rows.clear();
      filter.reset();
    }
  }

  @Test
  void lampOfTheMainsIsForgottenAndTheObjectBesideItIsTracked() {
    EventPacket object = shapes(12).box(6, 6, 20_000, along(10, 100, 12, 0)).events(8);
    SplittableRandom random = new SplittableRandom(3);
    EventList events = new EventList();
    for (int i = 0; i < object.size(); i++) {
      events.add(object.timeUs(i), object.x(i), object.y(i), object.isOn(i));
    }
    for (long halfWaveUs = 0; halfWaveUs < 8_000_000; halfWaveUs += 5_000) {
      for (int pixel = 0; pixel < 144; pixel++) {
        long timeUs = halfWaveUs + random.nextInt(1_500);
        events.add(timeUs, 90 + pixel % 12, 30 + pixel / 12, halfWaveUs % 10_000 == 0);
      }
    }
    filter.process(events.sorted(0, 8_000_000));
    filter.notified(new EndOfStream(0));
    List<ObjectTrack> later = rows.stream().filter(row -> row.timeUs() > 3_000_000).toList();
    assertEquals(1, later.stream().map(ObjectTrack::id).distinct().count());
    later.forEach(row -> assertEquals(100, row.yPx(), 5));
  }

  @Test
  void silenceOfAnHourOrAResetEndsAllObjects() {
    EventPacket events = shapes(8).box(6, 6, 20_000, along(20, 60, 60, 0)).events(1);
    filter.process(EventPackets.copy(events));
    filter.process(EventPackets.shifted(events, 3_600_000_000L));
    Map<Integer, List<ObjectTrack>> paths = byIdentity();
    assertEquals(2, paths.size());
    assertTrue(paths.get(1).get(paths.get(1).size() - 1).timeUs() < 10_000_000);
    filter.notified(new Reset(Reset.Cause.USER, 0, 0));
    rows.clear();
    filter.process(EventPackets.copy(events));
    assertEquals(java.util.Set.of(3), byIdentity().keySet());
    filter.notified(new Reset(Reset.Cause.SEEK, 0, 0));
    rows.clear();
    filter.process(EventPackets.copy(events));
    assertEquals(java.util.Set.of(1), byIdentity().keySet());
  }

  @Test
  void reportRateFollowsItsSetting() {
    ObjectTrackerFilter fast = subscribed("reportRateHz=250");
    fast.process(shapes(9).box(6, 6, 20_000, along(20, 60, 60, 0)).events(1));
    assertTrue(rows.stream().allMatch(row -> row.timeUs() % 4000 == 0));
    assertTrue(rows.size() > 200, rows.size() + " rows");
  }

  @Test
  void invalidSettingsAreRejected() {
    for (String absurd : List.of("scalePx=NaN", "confirmS=0", "coastTimeS=-1", "reportRateHz=0")) {
      assertThrows(
          SettingsProblem.class, () -> ObjectTrackerSettings.defaults().with(absurd), absurd);
    }
  }

  @Test
  void positionAndVelocityErrorsLieWithinStatedDeviations() {
    int withinPosition = 0;
    int withinVelocity = 0;
    int all = 0;
    for (int seed = 0; seed < 20; seed++) {
      rows.clear();
      filter.reset();
      double vy = 3 * seed - 30;
      run(shapes(200 + seed).box(7, 7, 20_000, along(20, 64, 60, vy)), 1.2);
      for (ObjectTrack row : rows) {
        if (row.ageS() < 0.5 || row.timeUs() % 100_000 != 0) {
          continue;
        }
        all++;
        double errorPx = row.xPx() - 20 - 60 * row.timeUs() * 1e-6;
        withinPosition += Math.abs(errorPx) < 1.96 * row.sdXPx() ? 1 : 0;
        withinVelocity += Math.abs(row.vxPxS() - 60) < 1.96 * row.sdVxPxS() ? 1 : 0;
      }
    }
    assertTrue(all > 100, all + " rows");
    assertTrue(withinPosition >= 0.92 * all, withinPosition + " places of " + all);
    assertTrue(withinVelocity >= 0.92 * all, withinVelocity + " velocities of " + all);
  }
}
