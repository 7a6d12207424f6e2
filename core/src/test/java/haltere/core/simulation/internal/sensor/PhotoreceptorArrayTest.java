package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.RunSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A pixel that low-passes the photocurrent, compared with its model equations. */
class PhotoreceptorArrayTest {
  private static final double TAU_US = 100;
  private static final double THRESHOLD = 0.2;
  private static final SensorSettings SENSOR = new SensorSettings(16, 16);
  private static final int PIXEL = 5 * 16 + 7;

  private static double hertz(double tauUs) {
    return tauUs == 0 ? 0 : 1e6 / (2 * Math.PI * tauUs);
  }

  /** Events of one pixel whose light changes evenly during some time, from 1000 us on. */
  private static EventPacket events(
      double tauUs, boolean followsLight, double followerUs, double refractoryUs, double[] steps) {
    PixelSettings settings = new PixelSettings(THRESHOLD, 0, hertz(tauUs), 0, 0, refractoryUs, 0);
    EventMerger merger = new EventMerger(settings, SENSOR, RunSettings.defaults());
    PhotoreceptorArray pixels =
        new PhotoreceptorArray(
            settings,
            new PhotoreceptorSettings(followsLight, hertz(followerUs)),
            SENSOR,
            1,
            merger);
    for (int i = 0; i < steps.length; i += 3) {
      pixels.change(PIXEL, steps[i], steps[i] + steps[i + 1], steps[i + 2]);
    }
    EventPacket out = new EventPacket(16);
    for (int us = 1000; us <= 100_000; us += 1000) {
      pixels.advanceAll(us);
      merger.release(us, out);
    }
    return out;
  }

  /** From 1 to a light within a tenth of a microsecond, at 500 us. */
  private static EventPacket step(double tauUs, boolean followsLight, double light) {
    return events(tauUs, followsLight, 0, 0, new double[] {500, 0.1, light});
  }

  @Test
  void logarithmOfTheFilteredCurrentIsCompared() {
    // 1 - 0.6 (1 - e^(-t / tau)) = e^-(n threshold)
    EventPacket events = step(TAU_US, false, 0.4);

    assertEquals(4, events.size());
    for (int n = 1; n <= 4; n++) {
      double share = (1 - Math.exp(-n * THRESHOLD)) / 0.6;
      assertEquals(500 - TAU_US * Math.log(1 - share), events.timeUs(n - 1), 1.6, "event " + n);
      assertEquals(false, events.isOn(n - 1));
    }
    assertEquals(7, events.x(0));
    assertEquals(5, events.y(0));
  }

  @Test
  void pixelSpeedIsProportionalToLight() {
    EventPacket plain = step(TAU_US, false, 0.5);
    EventPacket following = step(TAU_US, true, 0.5);

    assertEquals(3, plain.size());
    assertEquals(3, following.size());
    for (int i = 0; i < 3; i++) {
      assertEquals(2 * (plain.timeUs(i) - 500), following.timeUs(i) - 500, 3);
    }
  }

  @Test
  void moreLightReducesTheLatency() {
    EventPacket more = step(TAU_US, true, 1.5);
    EventPacket less = step(TAU_US, true, 1 / 1.5);

    assertEquals(2, more.size());
    assertEquals(2, less.size());
    for (int i = 0; i < 2; i++) {
      assertEquals(true, more.isOn(i));
      assertEquals(false, less.isOn(i));
      assertTrue(more.timeUs(i) - 500 < 0.7 * (less.timeUs(i) - 500), more + " " + less);
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void slowerPixelsMakeLaterAndFewerEvents(boolean followsLight) {
    long lastFirst = 0;
    int lastCount = Integer.MAX_VALUE;
    for (double tau : new double[] {0, 10, 25, 50}) {
      EventPacket events = events(tau, followsLight, 0, 0, new double[] {500, 5, 0.3, 560, 5, 1});
      assertTrue(events.size() < lastCount, tau + " us: " + events);
      assertTrue(events.timeUs(0) > lastFirst, tau + " us: " + events);
      lastCount = events.size();
      lastFirst = events.timeUs(0);
    }
    assertTrue(events(1000, followsLight, 0, 0, new double[] {500, 5, 0.3, 560, 5, 1}).isEmpty());
  }

  @Test
  void sourceFollowerDelaysEvents() {
    double[] step = {500, 0.1, 0.5};
    EventPacket without = events(50, false, 0, 0, step);
    EventPacket with = events(50, false, 80, 0, step);

    assertEquals(without.size(), with.size());
    for (int i = 0; i < with.size(); i++) {
      assertTrue(with.timeUs(i) > without.timeUs(i) + 20, with.toString());
    }
  }

  @Test
  void sourceFollowerLowPassesTheLogarithm() {
    EventPacket events = events(TAU_US, false, TAU_US, 0, new double[] {500, 0.1, 0.6});
    double current = 1;
    double level = 0;
    int found = 0;
    double stepUs = 0.01;
    for (double t = 500; t < 3000; t += stepUs) {
      current += (0.6 - current) * stepUs / TAU_US;
      level += (Math.log(current) - level) * stepUs / TAU_US;
      if (level <= -THRESHOLD * (found + 1)) {
        assertEquals(t, events.timeUs(found++), 2.5);
      }
    }
    assertEquals(2, found);
    assertEquals(2, events.size());
  }

  @Test
  void eventTimesLieWithinAnEvenChange() {
    // ln(1 - 0.5 t / 1000) = -n threshold
    EventPacket events = events(0, true, 0, 0, new double[] {1500, 1000, 0.5});

    assertEquals(3, events.size());
    for (int n = 1; n <= 3; n++) {
      assertEquals(1500 + 2000 * (1 - Math.exp(-n * THRESHOLD)), events.timeUs(n - 1), 1.5);
    }
  }

  @Test
  void referenceLevelIsTakenAtTheEndOfTheRefractoryPeriod() {
    EventPacket blind = events(0, true, 0, 300, new double[] {1500, 1000, 0.5});

    double first = 2000 * (1 - Math.exp(-THRESHOLD));
    double reference = 1 - 0.5 * (first + 300) / 1000;
    double second = 2000 * (1 - reference * Math.exp(-THRESHOLD));
    assertEquals(2, blind.size());
    assertEquals(1500 + first, blind.timeUs(0), 1.5);
    assertEquals(1500 + second, blind.timeUs(1), 1.5);
  }

  @Test
  void constantLightMakesNoEvent() {
    assertTrue(events(TAU_US, true, 50, 0, new double[] {500, 10, 1, 5000, 10, 0.9}).isEmpty());
  }
}
