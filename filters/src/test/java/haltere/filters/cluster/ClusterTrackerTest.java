package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.settings.SettingsProblem;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class ClusterTrackerTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final BlobPath CIRCLE = new BlobPath(64, 64, 30, 1_000_000, 6);

  private final List<ClusterTrack> rows = new ArrayList<>();
  private ClusterTracker tracker;

  private ClusterTracker tracker(String... changes) {
    rows.clear();
    tracker =
        new ClusterTracker(
            SENSOR,
            ClusterTrackerSettings.defaults().with(changes),
            timeUs -> rows.addAll(tracker.tracks()));
    return tracker;
  }

  private Set<Integer> identities() {
    return rows.stream().map(ClusterTrack::id).collect(Collectors.toSet());
  }

  private static EventPacket blob(long seed, long durationUs) {
    return EventPackets.blob(SENSOR, seed, durationUs, CIRCLE, 20_000, 0);
  }

  @Test
  void afterAGapOfAnHourThereIsNoStaleClusterAndNoIdentityTwice() {
    EventPacket events = blob(1, 300_000);
    events.append(EventPackets.shifted(blob(2, 300_000), 3_600_000_000L), 0, 5000);
    tracker().track(events);
    assertEquals(Set.of(1, 2), identities());
    for (ClusterTrack row : rows) {
      boolean early = row.timeUs() < 1_000_000;
      assertTrue(early || row.timeUs() >= 3_600_000_000L, "in the gap: " + row);
      assertEquals(early ? 1 : 2, row.id());
    }
  }

  @Test
  void theRateIsTheTrueOne() {
    tracker().track(blob(3, 1_000_000));
    ClusterTrack last = rows.get(rows.size() - 1);
    assertEquals(20_000, last.rateHz(), 1500);
  }

  @Test
  void noiseOfManyPlacesMakesNoClusterAndNeverMoreThanAllowed() {
    tracker("output.mostClusters=5").track(EventPackets.uniform(SENSOR, 4, 400_000, 0, 1));
    assertTrue(rows.size() < 5, "rows in pure noise: " + rows.size());
  }

  @Test
  void aPixelThatFlickersIsNoThing() {
    EventPacket events = new EventPacket(0);
    for (long timeUs = 0; timeUs < 500_000; timeUs += 100) {
      events.append(timeUs, 40, 50, true);
    }
    tracker().track(events);
    assertEquals(List.of(), rows);
  }

  @Test
  void eventsOfTheOtherPolarityDoNotCount() {
    EventPacket off = new EventPacket(0);
    EventPacket both = blob(5, 300_000);
    for (int i = 0; i < both.size(); i++) {
      off.append(both.timeUs(i), both.x(i), both.y(i), false);
    }
    tracker("events.polarity=on").track(EventPackets.copy(off));
    assertEquals(List.of(), rows);
    tracker("events.polarity=off").track(off);
    assertEquals(Set.of(1), identities());
  }

  @Test
  void withAFixedSizeAClusterKeepsItsRadiusAndAspect() {
    tracker(
            "growth.size=false",
            "form.size=0.1",
            "form.aspect=4",
            "form.angle=fixed",
            "form.outline=box")
        .track(blob(6, 300_000));
    ClusterTrack last = rows.get(rows.size() - 1);
    assertEquals(12.8, last.radiusPx(), 1e-9);
    assertEquals(4, last.radiusAcrossPx() / last.radiusAlongPx(), 1e-9);
    assertEquals(0, last.angleRad(), 1e-9);
  }

  @Test
  void towardsTheVanishingPointClustersAreSmaller() {
    tracker("growth.size=false", "perspective.enabled=true").track(blob(7, 1_000_000));
    ClusterTrack top = rows.stream().reduce((a, b) -> a.yPx() > b.yPx() ? a : b).orElseThrow();
    ClusterTrack bottom = rows.stream().reduce((a, b) -> a.yPx() < b.yPx() ? a : b).orElseThrow();
    assertTrue(top.radiusPx() < 0.6 * bottom.radiusPx(), top + " / " + bottom);
  }

  @Test
  void eachWayOfMixingFollowsABlob() {
    for (String mixing : List.of("per-event", "per-time", "adaptive")) {
      for (String predict : List.of("true", "false")) {
        tracker("motion.mixing=" + mixing, "motion.predict=" + predict).track(blob(8, 800_000));
        ClusterTrack last = rows.get(rows.size() - 1);
        double error =
            Math.hypot(last.xPx() - CIRCLE.x(last.timeUs()), last.yPx() - CIRCLE.y(last.timeUs()));
        assertTrue(error < 5, mixing + " " + predict + " is off by " + error);
      }
    }
  }

  @Test
  void aClusterDiesWhenItsOutlineTouchesTheBorderIfItIsToldTo() {
    BlobPath outwards = new BlobPath(64, 64, 62, 4_000_000, 5);
    EventPacket events = EventPackets.blob(SENSOR, 9, 1_000_000, outwards, 20_000, 0);
    tracker("life.border=outline").track(EventPackets.copy(events));
    assertTrue(
        rows.stream().allMatch(row -> row.xPx() + row.radiusPx() < 130), "touches the border");
    int kept = rows.size();
    tracker("life.border=never").track(events);
    assertTrue(rows.size() > kept, rows.size() + " rows, not more than " + kept);
  }

  @Test
  void onlyEventsOfVisibleClustersPassIfItIsToldSo() {
    EventPacket events = EventPackets.blob(SENSOR, 10, 500_000, CIRCLE, 20_000, 2);
    int before = events.size();
    tracker("output.onlyClustered=true").track(events);
    assertTrue(events.size() > 0.2 * before && events.size() < 0.9 * before, "" + events.size());
  }

  @Test
  void whatIsNoNumberOrAbsurdIsRefusedWhereItIsSet() {
    ClusterTrackerSettings settings = ClusterTrackerSettings.defaults();
    for (String absurd :
        List.of(
            "form.size=NaN", "motion.mixingFactor=2", "life.lifetimeUs=-1", "growth.events=0")) {
      assertThrows(SettingsProblem.class, () -> settings.with(absurd), absurd);
    }
  }

  @Test
  void anObserverReadsEachEventOnceAndMayFeedBack() {
    ClusterTracker observed = tracker();
    double[] events = {0};
    List<Long> times = new ArrayList<>();
    observed.observe(
        (timeUs, readings) -> {
          times.add(timeUs);
          for (int i = 0; i < readings.count(); i++) {
            events[0] += readings.newEvents(i);
            if (readings.newEvents(i) > 0) {
              long at = timeUs - Math.round(readings.measuredAgeUs(i));
              assertEquals(CIRCLE.x(at), readings.measuredX(i), 4);
              assertEquals(CIRCLE.y(at), readings.measuredY(i), 4);
            }
            readings.feedBack(i, CIRCLE.x(timeUs), CIRCLE.y(timeUs), Double.NaN, 0);
            readings.feedBack(i, CIRCLE.x(timeUs), CIRCLE.y(timeUs), 0, 0);
            assertEquals(CIRCLE.x(timeUs), readings.x(i));
          }
        },
        2000);
    EventPacket blob = blob(11, 500_000);
    observed.track(blob);
    assertTrue(times.stream().allMatch(time -> time % 2000 == 0));
    assertEquals(blob.size(), events[0], 0.05 * blob.size());
  }

  @Test
  void aClusterThatIsKeptAliveOutlivesItsLifetime() {
    ClusterTracker observed = tracker();
    observed.observe(
        (timeUs, readings) -> {
          for (int i = 0; i < readings.count(); i++) {
            readings.keepAlive(i, 700_000);
          }
        },
        1000);
    EventPacket events = blob(12, 300_000);
    events.append(2_000_000, 0, 0, true);
    observed.track(events);
    long last = rows.stream().mapToLong(ClusterTrack::timeUs).max().orElseThrow();
    assertTrue(last >= 500_000 && last < 720_000, "last seen at " + last);
  }
}
