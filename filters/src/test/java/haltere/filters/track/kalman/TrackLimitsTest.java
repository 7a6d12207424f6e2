package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.core.stream.Reset;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.filters.track.TrackUpdate;
import haltere.testing.EventPackets;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** What is absurd, endless or too much for tracks: from events and settings to results. */
class TrackLimitsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final long HOUR_US = 3_600_000_000L;

  private final List<TrackPoint> points = new ArrayList<>();
  private final List<TrackUpdate> updates = new ArrayList<>();

  private KalmanTracksFilter filter(SensorGeometry sensor) {
    KalmanTracksFilter filter = new KalmanTracksFilter(sensor, KalmanTracksSettings.defaults());
    filter.points().subscribe(points::add);
    filter.updates().subscribe(updates::add);
    return filter;
  }

  private void assertSane() {
    assertFalse(updates.isEmpty());
    for (TrackUpdate update : updates) {
      assertTrue(update.pXx() > 0 && update.pXx() < 1000, "P is no place's: " + update);
      assertTrue(update.pVxvx() > 0 && update.pVxvx() < 1e6, "P is no velocity's: " + update);
      assertTrue(update.pXx() * update.pVxvx() > update.pXvx() * update.pXvx(), "P: " + update);
      assertTrue(update.pYy() * update.pVyvy() > update.pYvy() * update.pYvy(), "P: " + update);
      assertTrue(Double.isFinite(update.nis()), "NIS: " + update);
    }
  }

  @Test
  void aGapOfAnHourLeavesNoTrackAndNoCovarianceOfAnHour() {
    EventPacket dots = KalmanTracksFilterTest.dots(SENSOR, 3, 500_000);
    EventPacket events = EventPackets.copy(dots);
    events.append(EventPackets.shifted(dots, HOUR_US), 0, dots.size());
    filter(SENSOR).process(events);
    assertSane();
    int lastBefore = 0;
    for (TrackPoint point : points) {
      boolean before = point.timeUs() < 2_000_000;
      assertTrue(before || point.timeUs() >= HOUR_US, "in the gap: " + point);
      lastBefore = before ? Math.max(lastBefore, point.id()) : lastBefore;
      assertTrue(before || point.id() > lastBefore, "from before the gap: " + point);
    }
    assertTrue(points.get(points.size() - 1).timeUs() > HOUR_US + 400_000);
  }

  @Test
  void afterEachCauseOfAResetTimeMayGoBackAndNoOldTrackIsSeen() {
    EventPacket dots = KalmanTracksFilterTest.dots(SENSOR, 4, 400_000);
    for (Reset.Cause cause : Reset.Cause.values()) {
      points.clear();
      updates.clear();
      KalmanTracksFilter filter = filter(SENSOR);
      filter.process(EventPackets.shifted(dots, HOUR_US));
      int before = points.stream().mapToInt(TrackPoint::id).max().orElseThrow();
      points.clear();
      filter.notified(new Reset(cause));
      filter.process(EventPackets.copy(dots));
      assertSane();
      assertFalse(points.isEmpty());
      for (TrackPoint point : points) {
        assertTrue(point.timeUs() < 1_000_000, "of a time before " + cause + ": " + point);
        assertTrue(point.id() > before, "of an object before " + cause + ": " + point);
      }
    }
  }

  @Test
  void theNoiseOfTenThousandThingsMakesNoMoreTracksThanAllowedAndTakesNoLonger() {
    SensorGeometry sensor = new SensorGeometry(640, 480);
    // Ten million events a second: a thousand for each of ten thousand things.
    EventPacket events = EventPackets.uniform(sensor, 11, 600_000, 0, 0.1);
    KalmanTracksFilter filter = filter(sensor);
    long beforeNs = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    filter.process(events);
    double nsPerEvent =
        (double) (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - beforeNs)
            / events.size();
    assertTrue(nsPerEvent < 1000, nsPerEvent + " ns an event");
    int most = KalmanTracksSettings.defaults().clusters().output().mostClusters();
    for (TrackPoint point : points) {
      long atATime = points.stream().filter(other -> other.timeUs() == point.timeUs()).count();
      assertTrue(atATime <= most, atATime + " tracks");
    }
  }

  @Test
  void eachNumberOfTheSettingsHasARangeOutsideWhichItIsRefused() {
    KalmanTracksSettings settings = KalmanTracksSettings.defaults();
    int numbers = 0;
    for (Parameter parameter : SettingsSchema.of(KalmanTracksSettings.class).parameters()) {
      String name = parameter.name();
      if (parameter.type() == double.class) {
        numbers++;
        for (String absurd : List.of("NaN", "Infinity", "-Infinity", "1e300", "-1e300")) {
          assertRefused(settings, name + "=" + absurd);
        }
      } else if (parameter.type() == int.class || parameter.type() == long.class) {
        numbers++;
        for (String absurd : List.of("NaN", "2147483647", "-2147483648", "1e300", "")) {
          assertRefused(settings, name + "=" + absurd);
        }
      }
    }
    assertTrue(numbers > 40, "only " + numbers + " numbers");
    assertEquals(settings, settings.with("life.coastTimeS=" + settings.life().coastTimeS()));
  }

  private static void assertRefused(KalmanTracksSettings settings, String absurd) {
    SettingsProblem problem =
        assertThrows(SettingsProblem.class, () -> settings.with(absurd), absurd);
    String name = absurd.substring(absurd.lastIndexOf('.') + 1, absurd.indexOf('='));
    String said = problem.getMessage().toLowerCase(Locale.ROOT);
    assertTrue(said.contains(name.toLowerCase(Locale.ROOT)), said);
  }
}
