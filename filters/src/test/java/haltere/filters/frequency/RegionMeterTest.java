package haltere.filters.frequency;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.stream.Reset;
import java.time.Duration;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Rate and frequency of a region. */
class RegionMeterTest {
  private static final PixelRegion REGION = PixelRegion.between(20, 30, 10, 10);

  /** Something that passes the region with a frequency, over noise, for a second. */
  private static EventPacket passing(double frequencyHz, double noiseShare, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket packet = new EventPacket(1);
    for (long timeUs = 0; timeUs < 1_000_000; timeUs += 20) {
      double phase = timeUs * 1e-6 * frequencyHz % 1;
      boolean inside = phase < 0.2 || random.nextDouble() < noiseShare;
      if (inside && random.nextDouble() < 0.5) {
        packet.append(
            timeUs,
            EventAddress.pack(
                10 + random.nextInt(11), 10 + random.nextInt(21), random.nextBoolean()));
      }
    }
    return packet;
  }

  @Test
  void regionIncludesBothCorners() {
    assertEquals(new PixelRegion(10, 10, 11, 21), REGION);
    assertEquals(231, REGION.pixels());
    assertEquals(new PixelRegion(-2, 3, 5, 5), PixelRegion.around(0, 5, 2));
  }

  @Test
  void frequencyIsAccurateToAFewTenthsOfAPercent() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < 30; i++) {
      double frequencyHz = Math.exp(random.nextDouble(Math.log(8), Math.log(700)));
      RegionMeter meter = new RegionMeter(REGION);
      meter.packet(passing(frequencyHz, 0.1, i));
      assertEquals(frequencyHz, meter.measure(true).frequencyHz(), 0.005 * frequencyHz);
    }
  }

  @Test
  void noiseHasNoFrequency() {
    RegionMeter meter = new RegionMeter(REGION);
    meter.packet(passing(200, 1, 3));
    assertTrue(Double.isNaN(meter.measure(true).frequencyHz()));
  }

  @Test
  void fewScatteredEventsHaveNoFrequency() {
    for (int seed = 0; seed < 200; seed++) {
      RegionMeter meter = new RegionMeter(new PixelRegion(0, 0, 8, 8));
      EventPacket events = new EventPacket(64);
      new SplittableRandom(seed)
          .longs(2 + seed % 50, 0, 800_000)
          .sorted()
          .forEach(timeUs -> events.append(timeUs, 3, 3, true));
      meter.packet(events);
      meter.advanceTo(810_000);
      double frequencyHz = meter.measure(true).frequencyHz();
      assertTrue(Double.isNaN(frequencyHz), frequencyHz + " Hz of " + events.size() + " events");
    }
  }

  @Test
  void irregularBurstsNeverHangTheMeter() {
    assertTimeoutPreemptively(
        Duration.ofSeconds(30),
        () -> {
          for (int seed = 0; seed < 100; seed++) {
            RegionMeter meter = new RegionMeter(REGION);
            meter.packet(bursts(seed));
            double frequencyHz = meter.measure(true).frequencyHz();
            assertTrue(
                Double.isNaN(frequencyHz) || frequencyHz >= 4 && frequencyHz <= 2500,
                frequencyHz + " Hz of bursts " + seed);
          }
        });
  }

  /** Events that come in bursts, between which nothing is regular, for a second. */
  private static EventPacket bursts(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket packet = new EventPacket(1);
    long longestUs = random.nextLong(50, 5_000);
    long timeUs = 0;
    while (timeUs < 1_000_000) {
      timeUs += random.nextLong(1, 3 * longestUs);
      long endUs = timeUs + random.nextLong(1, longestUs);
      for (; timeUs < endUs; timeUs += random.nextLong(1, 40)) {
        packet.append(timeUs, EventAddress.pack(15, 15, true));
      }
    }
    return packet;
  }

  @Test
  void rateIsThatOfTheLast100Ms() {
    RegionMeter meter = new RegionMeter(REGION);
    EventPacket packet = new EventPacket(1);
    for (int i = 0; i < 1000; i++) {
      packet.append(i * 1000L, EventAddress.pack(15, 15, i % 4 != 0));
      packet.append(i * 1000L, EventAddress.pack(50, 15, true));
    }
    meter.packet(packet);
    RegionMeasurement measured = meter.measure(false);
    assertEquals(1000, measured.rateEps(), 15, "those outside do not count");
    assertEquals(0.75, measured.onShare(), 0.01);
    meter.advanceTo(1_200_000);
    assertEquals(0, meter.measure(false).rateEps());
  }

  @Test
  void jumpClearsEarlierEvents() {
    RegionMeter meter = new RegionMeter(REGION);
    meter.packet(passing(100, 0, 5));
    meter.notified(new Reset(Reset.Cause.SEEK));
    assertEquals(RegionMeasurement.NOTHING, meter.measure(true));
  }

  @Test
  void resultsDoNotDependOnPacketBoundaries() {
    EventPacket whole = passing(150, 0.2, 9);
    RegionMeter once = new RegionMeter(REGION);
    once.packet(whole);
    RegionMeter cut = new RegionMeter(REGION);
    for (int i = 0; i < whole.size(); i++) {
      EventPacket one = new EventPacket(1);
      one.append(whole.timesUs()[i], whole.addresses()[i]);
      cut.packet(one);
    }
    assertEquals(once.measure(true), cut.measure(true));
  }
}
