package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.SceneRuns;
import org.junit.jupiter.api.Test;

/** Merging of pixel events into an ordered stream. */
class EventMergerTest {
  private static final SensorSettings SENSOR = new SensorSettings(128, 128);

  private static EventMerger merger(
      double latencyUs, double jitterUs, double refractoryUs, double busLimitEps, double lengthS) {
    return new EventMerger(
        new PixelSettings(0.2, 0, 0, latencyUs, jitterUs, refractoryUs, busLimitEps),
        SENSOR,
        new RunSettings(9, 5_000, lengthS, 1000));
  }

  private static int address(int pixel) {
    return EventAddress.pack(pixel % 128, pixel / 128, true);
  }

  @Test
  void delayHasItsMeanAndDeviationAndTheStreamStaysOrdered() {
    EventMerger merger = merger(100, 20, 0, 0, 0);
    EventPacket out = new EventPacket(16);
    int perInterval = 200;
    int intervals = 100;
    for (int k = 0; k < intervals; k++) {
      for (int i = 0; i < perInterval; i++) {
        // the place of an event tells when its change was, within its interval
        merger.add(k * 1000.0 + 5 * i + 0.5, address(i));
      }
      merger.release((k + 1) * 1000L, out);
    }
    merger.release((intervals + 1) * 1000L, out);
    double sum = 0;
    double square = 0;
    for (int i = 0; i < out.size(); i++) {
      int place = out.y(i) * 128 + out.x(i);
      double sinceBegin = out.timeUs(i) - 5_000 - 5 * place;
      double delay = sinceBegin - 1000 * Math.round((sinceBegin - 100) / 1000);
      sum += delay;
      square += delay * delay;
      assertTrue(i == 0 || out.timeUs(i - 1) <= out.timeUs(i));
    }
    double mean = sum / out.size();

    assertEquals(perInterval * intervals, out.size());
    assertEquals(100, mean, 0.6);
    assertEquals(20, Math.sqrt(square / out.size() - mean * mean), 0.4);
  }

  @Test
  void aDelayIsNeverNegative() {
    EventMerger merger = merger(10, 300, 0, 0, 0);
    EventPacket out = new EventPacket(16);
    for (int i = 0; i < 1000; i++) {
      merger.add(500, address(i));
    }
    merger.release(4000, out);

    assertEquals(1000, out.size());
    assertEquals(5_500, out.firstTimeUs());
    assertTrue(SceneRuns.count(out, i -> out.timeUs(i) == 5_500) > 300);
  }

  @Test
  void aPixelDoesNotFireTwiceWithinItsRefractoryPeriod() {
    EventMerger merger = merger(0, 0, 50, 0, 0);
    EventPacket out = new EventPacket(16);
    merger.add(100, address(1));
    merger.add(149, address(1));
    merger.add(149, address(2));
    merger.add(150, address(1));
    merger.release(1000, out);

    assertEquals(3, out.size());
    assertEquals(5_150, out.lastTimeUs());
  }

  @Test
  void busCarriesOneEventAtATimeAndDropsLateOnes() {
    EventMerger merger = merger(0, 0, 0, 100_000, 0);
    EventPacket out = new EventPacket(16);
    for (int i = 0; i < 300; i++) {
      merger.add(0, address(i));
    }
    merger.release(1000, out);

    assertEquals(101, out.size());
    assertEquals(199, merger.lost());
    for (int i = 0; i < out.size(); i++) {
      assertEquals(5_000 + 10 * i, out.timeUs(i));
    }
  }

  @Test
  void nothingFollowsTheEnd() {
    EventMerger merger = merger(100, 0, 0, 0, 0.001);
    EventPacket out = new EventPacket(16);
    merger.add(899, address(1));
    merger.add(900, address(2));
    merger.release(1000, out);
    merger.release(2000, out);

    assertEquals(1, out.size());
    assertEquals(5_999, out.lastTimeUs());
  }
}
