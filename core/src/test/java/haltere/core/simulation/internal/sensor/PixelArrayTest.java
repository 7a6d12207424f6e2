package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.SceneRuns;
import org.junit.jupiter.api.Test;

/** A pixel compared with its model equations. */
class PixelArrayTest {
  private static final double TAU_US = 100;
  private static final double BANDWIDTH_HZ = 1e6 / (2 * Math.PI * TAU_US);
  private static final SensorSettings SENSOR = new SensorSettings(16, 16);
  private static final int PIXEL = 5 * 16 + 7;

  private static PixelSettings pixel(double bandwidthHz, double refractoryUs) {
    return new PixelSettings(0.2, 0, bandwidthHz, 0, 0, refractoryUs, 0);
  }

  /** Events of one pixel from a shadow of a contrast that begins at 1000 us. */
  private static EventPacket shadow(PixelSettings settings, double contrast, double dwellUs) {
    EventMerger merger = new EventMerger(settings, SENSOR, RunSettings.defaults());
    PixelArray pixels = new PixelArray(settings, SENSOR, 1, merger);
    pixels.change(PIXEL, 1000, -contrast);
    pixels.change(PIXEL, 1000 + dwellUs, contrast);
    EventPacket out = new EventPacket(16);
    for (int us = 2000; us <= 100_000; us += 1000) {
      pixels.advanceAll(us);
      merger.release(us, out);
    }
    return out;
  }

  @Test
  void shadowMakesAnOffAndThenAnOnEvent() {
    EventPacket events = shadow(pixel(0, 0), 0.3, 50);

    assertEquals(2, events.size());
    assertEquals(1000, events.timeUs(0));
    assertEquals(false, events.isOn(0));
    assertEquals(1050, events.timeUs(1));
    assertEquals(true, events.isOn(1));
    assertEquals(7, events.x(0));
    assertEquals(5, events.y(0));
  }

  @Test
  void faintShadowsMakeNoEvent() {
    assertTrue(shadow(pixel(0, 0), 0.19, 500).isEmpty());
  }

  @Test
  void shadowsTooFastForThePhotoreceptorMakeNoEvent() {
    // the level falls by 0.5 (1 - e^(-d / tau)), which reaches 0.2 at d = -tau ln 0.6 = 51.08 us
    assertTrue(shadow(pixel(BANDWIDTH_HZ, 30), 0.5, 51.0).isEmpty());
    assertEquals(1, shadow(pixel(BANDWIDTH_HZ, 30), 0.5, 51.2).size());
  }

  @Test
  void photoreceptorDelaysAnEventUntilTheThreshold() {
    EventPacket events = shadow(pixel(BANDWIDTH_HZ, 30), 0.5, 10_000);

    assertEquals((long) (1000 - TAU_US * Math.log(1 - 0.2 / 0.5)), events.timeUs(0));
  }

  @Test
  void deepShadowMakesAnEventPerThreshold() {
    EventPacket events = shadow(pixel(BANDWIDTH_HZ, 0), 0.7, 10_000);

    assertEquals(3, SceneRuns.count(events, i -> !events.isOn(i)));
    assertEquals((long) (1000 - TAU_US * Math.log(1 - 0.2 / 0.7)), events.timeUs(0));
    assertEquals((long) (1000 - TAU_US * Math.log(1 - 0.4 / 0.7)), events.timeUs(1));
    assertEquals((long) (1000 - TAU_US * Math.log(1 - 0.6 / 0.7)), events.timeUs(2));
    assertEquals(3, SceneRuns.count(events, events::isOn));
  }

  @Test
  void referenceLevelIsTakenAtTheEndOfTheRefractoryPeriod() {
    EventPacket events = shadow(pixel(BANDWIDTH_HZ, 60), 0.7, 10_000);

    double first = -TAU_US * Math.log(1 - 0.2 / 0.7);
    double reference = -0.7 * (1 - Math.exp(-(first + 60) / TAU_US));
    double second = -TAU_US * Math.log(1 - (0.2 - reference) / 0.7);
    assertEquals((long) (1000 + first), events.timeUs(0));
    assertEquals((long) (1000 + second), events.timeUs(1));
    assertEquals(2, SceneRuns.count(events, i -> !events.isOn(i)));
  }

  @Test
  void slowPixelFiresLongAfterAChange() {
    double tauUs = 20_000;
    EventPacket events = shadow(pixel(1e6 / (2 * Math.PI * tauUs), 0), 0.3, 80_000);

    assertEquals(1, events.size());
    assertEquals(1000 - tauUs * Math.log(1 - 0.2 / 0.3), events.timeUs(0), 1);
  }

  @Test
  void thresholdsVaryBetweenPixelsAsConfigured() {
    PixelSettings settings = new PixelSettings(0.2, 0.03, 0, 0, 0, 0, 0);
    SensorSettings sensor = new SensorSettings(100, 100);
    int[] fired = new int[3];
    double[] contrasts = {0.17, 0.2, 0.23};
    for (int c = 0; c < contrasts.length; c++) {
      EventMerger merger = new EventMerger(settings, sensor, RunSettings.defaults());
      PixelArray pixels = new PixelArray(settings, sensor, 1, merger);
      for (int i = 0; i < 10_000; i++) {
        pixels.change(i, 10, -contrasts[c]);
      }
      pixels.advanceAll(1000);
      EventPacket out = new EventPacket(16);
      merger.release(1000, out);
      fired[c] = out.size();
    }

    // one standard deviation below the mean, the mean, one above
    assertEquals(1587, fired[0], 150);
    assertEquals(5000, fired[1], 200);
    assertEquals(8413, fired[2], 150);
  }
}
