package haltere.filters.noise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HotPixelsFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final long SECOND_US = 1_000_000;
  private static final int HOT = EventAddress.pack(40, 50, true);
  private static final int HOT_TOO = EventAddress.pack(41, 50, true);
  private static final int CORNER = EventAddress.pack(0, 0, true);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    HotPixelsSettings defaults = HotPixelsSettings.defaults();
    return new HotPixelsFilter(
        geometry, new HotPixelsSettings(50_000, defaults.rateHz(), defaults.ratio(), 2, 100));
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] hot = new int[10];
    for (int i = 0; i < hot.length; i++) {
      hot[i] =
          EventAddress.pack(
              random.nextInt(geometry.width()), random.nextInt(geometry.height()), true);
    }
    return EventPackets.withHotPixels(super.stream(geometry, seed), 700, hot);
  }

  @Test
  void singleHotPixelsPairsAndCornersAreBlockedAfterTheFirstPeriod() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    EventPacket packet =
        EventPackets.withHotPixels(noise(2 * SECOND_US), 200, HOT, HOT_TOO, CORNER);
    filter.filter(packet);
    assertTrue(filter.isBlocked(40, 50));
    assertTrue(filter.isBlocked(41, 50));
    assertTrue(filter.isBlocked(0, 0));
    assertEquals(3, filter.blockedPixels());
    for (int i = packet.indexAtOrAfter(SECOND_US); i < packet.size(); i++) {
      assertFalse(filter.isBlocked(packet.x(i), packet.y(i)), "an event of a blocked pixel");
    }
  }

  @Test
  void pixelBelowTheAbsoluteRateIsNotHot() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    filter.filter(EventPackets.withHotPixels(noise(2 * SECOND_US), 40, HOT));
    assertEquals(0, filter.blockedPixels());
  }

  @Test
  void hotPixelUnderAWingIsBlockedAndWingEdgesAreNot() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    EventPacket wing = wing(2 * SECOND_US, 1);
    filter.filter(EventPackets.copy(wing));
    assertEquals(0, filter.blockedPixels(), "pixels of the wing were blocked");
    filter.reset();
    filter.filter(EventPackets.withHotPixels(wing, 5000, EventAddress.pack(90, 70, true)));
    assertTrue(filter.isBlocked(90, 70));
    assertEquals(1, filter.blockedPixels());
  }

  @Test
  void onlyHotPixelsOfTheSimulatedFlyAreBlocked() {
    for (String hot : new String[] {"noise.hotPixels=0", "noise.hotPixels=12"}) {
      FlyScene scene =
          new FlyScene(
              FlySceneSettings.defaults().with(hot, "noise.hotRateHz=1000", "run.durationS=1.1"));
      HotPixels filter = new HotPixels(scene.geometry(), HotPixelsSettings.defaults());
      StreamHandler feeder =
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              filter.filter(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              // Nothing to tell an algorithm.
            }
          };
      while (scene.next(feeder)) {
        // Until the end.
      }
      int expected = hot.endsWith("12") ? 12 : 0;
      assertEquals(expected, filter.blockedPixels(), hot);
    }
  }

  @Test
  void calmPixelsPassAgainAfterTheConfiguredPeriods() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    filter.filter(EventPackets.withHotPixels(noise(SECOND_US), 200, HOT));
    assertTrue(filter.isBlocked(40, 50));
    filter.filter(EventPackets.shifted(noise(1_400_000), SECOND_US));
    assertTrue(filter.isBlocked(40, 50), "released too early");
    filter.filter(EventPackets.shifted(noise(800_000), 2_400_000));
    assertFalse(filter.isBlocked(40, 50), "not released");
  }

  @Test
  void longSilenceReleasesAllPixels() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    filter.filter(EventPackets.withHotPixels(noise(SECOND_US), 200, HOT));
    EventPacket later = new EventPacket(0);
    later.append(3600 * SECOND_US, 40, 50, true);
    filter.filter(later);
    assertEquals(1, later.size());
    assertEquals(0, filter.blockedPixels());
  }

  @Test
  void busiestPixelsAreBlockedUpToTheLimit() {
    HotPixels filter = new HotPixels(SENSOR, new HotPixelsSettings(500_000, 50, 6, 4, 2));
    EventPacket packet = EventPackets.withHotPixels(noise(SECOND_US), 100, HOT, CORNER);
    int busy = EventAddress.pack(80, 20, true);
    int busier = EventAddress.pack(20, 100, true);
    packet = EventPackets.withHotPixels(packet, 300, busy, busier);
    filter.filter(packet);
    assertEquals(2, filter.blockedPixels());
    assertTrue(filter.isBlocked(80, 20));
    assertTrue(filter.isBlocked(20, 100));
  }

  @Test
  void loweredLimitAppliesAtOnce() {
    HotPixels filter = new HotPixels(SENSOR, HotPixelsSettings.defaults());
    filter.filter(EventPackets.withHotPixels(noise(SECOND_US), 200, HOT, CORNER));
    assertEquals(2, filter.blockedPixels());
    filter.apply(new HotPixelsSettings(500_000, 50, 6, 4, 1));
    assertEquals(1, filter.blockedPixels());
    EventPacket packet = new EventPacket(0);
    packet.append(SECOND_US, 40, 50, true);
    packet.append(SECOND_US, 0, 0, true);
    filter.filter(packet);
    assertEquals(1, packet.size());
  }

  @Test
  void hotPixelsStayBlockedAfterADataLoss() {
    HotPixelsFilter filter = new HotPixelsFilter(SENSOR, HotPixelsSettings.defaults());
    filter.process(EventPackets.withHotPixels(noise(SECOND_US), 200, HOT));
    filter.notified(new DataLost(512, 128, SECOND_US, SECOND_US + 1, "the test"));
    EventPacket packet = new EventPacket(0);
    packet.append(SECOND_US + 1, 40, 50, true);
    filter.process(packet);
    assertTrue(packet.isEmpty());
  }

  private static EventPacket noise(long durationUs) {
    return EventPackets.uniform(
        SENSOR, 1, (int) (durationUs * SENSOR.pixels() / SECOND_US), 0, 1e6 / SENSOR.pixels());
  }

  /** A wing of 40 px that beats at 200 Hz by 70 degrees to either side of the x axis. */
  private static EventPacket wing(long durationUs, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket packet = new EventPacket(0);
    double stepUs = 20;
    for (double timeUs = 0; timeUs < durationUs; timeUs += stepUs) {
      double angle = Math.toRadians(70) * Math.sin(2 * Math.PI * 200 * timeUs / 1e6);
      for (int n = 0; n < 4; n++) {
        double distance = 40 * random.nextDouble();
        packet.append(
            (long) timeUs,
            (int) Math.round(64 + distance * Math.cos(angle)),
            (int) Math.round(64 + distance * Math.sin(angle)),
            random.nextBoolean());
      }
    }
    return packet;
  }
}
