package haltere.filters.frequency;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.simulation.internal.sensor.BackgroundNoise;
import haltere.core.simulation.internal.sensor.EventMerger;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.PixelArray;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventFilterContract;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FrequencyMapFilterTest extends EventFilterContract {
  private static final int SIDE = 32;
  private static final SensorGeometry SENSOR = new SensorGeometry(SIDE, SIDE);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new FrequencyMapFilter(geometry, FrequencyMapSettings.defaults());
  }

  /** A second before a lamp in the left half of the picture, whose light follows a sine. */
  private static EventPacket lamp(double frequencyHz, boolean noisy) {
    PixelSettings pixels = PixelSettings.defaults();
    SensorSettings sensor = new SensorSettings(SIDE, SIDE);
    EventMerger merger = new EventMerger(pixels, sensor, RunSettings.defaults());
    PixelArray array = new PixelArray(pixels, sensor, 1, merger);
    BackgroundNoise noise = new BackgroundNoise(NoiseSettings.defaults(), sensor, 1);
    EventPacket events = new EventPacket(0);
    double light = 0;
    long stepUs = 100;
    for (long timeUs = 0; timeUs < 1_000_000; timeUs += stepUs) {
      double now = Math.log(1 + 0.7 * Math.sin(2e-6 * Math.PI * frequencyHz * timeUs));
      for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
        if (pixel % SIDE < SIDE / 2) {
          array.change(pixel, timeUs, now - light);
        }
      }
      light = now;
      if (noisy) {
        noise.addUntil(timeUs, merger);
      }
      array.advanceAll(timeUs);
      merger.release(timeUs, events);
    }
    return events;
  }

  private static double[] frequencies(FrequencyMap map, long nowUs, int fromX, int toX) {
    List<Double> found = new ArrayList<>();
    for (int y = 0; y < SIDE; y++) {
      for (int x = fromX; x < toX; x++) {
        double frequency = map.frequencyHz(x, y, nowUs);
        if (!Double.isNaN(frequency)) {
          found.add(frequency);
        }
      }
    }
    return found.stream().mapToDouble(Double::doubleValue).sorted().toArray();
  }

  @ParameterizedTest
  @ValueSource(doubles = {8, 100, 500})
  void lampsHaveAFrequencyAndDarkPixelsNone(double frequencyHz) {
    FrequencyMap map = new FrequencyMap(SENSOR, FrequencyMapSettings.defaults());
    EventPacket events = lamp(frequencyHz, true);
    map.add(events);
    double[] lit = frequencies(map, events.lastTimeUs(), 0, SIDE / 2);
    assertTrue(lit.length > 0.9 * SIDE * SIDE / 2, lit.length + " pixels");
    assertEquals(frequencyHz, lit[lit.length / 2], 0.01 * frequencyHz);
    assertEquals(frequencyHz, lit[lit.length / 20], 0.05 * frequencyHz);
    assertEquals(frequencyHz, lit[lit.length - 1 - lit.length / 20], 0.05 * frequencyHz);
    double[] dark = frequencies(map, events.lastTimeUs(), SIDE / 2, SIDE);
    assertTrue(dark.length < 0.02 * SIDE * SIDE / 2, dark.length + " pixels");
  }

  @Test
  void silentPixelsLoseTheirFrequency() {
    FrequencyMap map = new FrequencyMap(SENSOR, FrequencyMapSettings.defaults());
    EventPacket events = lamp(100, false);
    map.add(events);
    int lit = frequencies(map, events.lastTimeUs(), 0, SIDE).length;
    assertTrue(frequencies(map, events.lastTimeUs() + 110_000, 0, SIDE).length < lit / 20);
    assertEquals(0, frequencies(map, events.lastTimeUs() + 2_100_000, 0, SIDE).length);
  }

  @Test
  void memoryIsTenOfTheLongestPeriods() {
    FrequencyMap map = new FrequencyMap(SENSOR, FrequencyMapSettings.defaults());
    assertEquals(2_000_000, map.memoryUs());
    EventPacket events = new EventPacket(0);
    for (int k = 0; k < 6; k++) {
      events.append(180_000L * k, 3, 4, true);
      events.append(180_000L * k + 1_000, 3, 4, false);
    }
    map.add(events);
    assertEquals(1 / 0.18, map.frequencyHz(3, 4, events.lastTimeUs() + 900_000), 0.1);
    assertEquals(Double.NaN, map.frequencyHz(3, 4, events.lastTimeUs() + 1_100_000));
  }

  @Test
  void twoPassagesPerPeriodYieldTheFrequencyOfThePeriod() {
    FrequencyMap map = new FrequencyMap(SENSOR, FrequencyMapSettings.defaults());
    EventPacket events = new EventPacket(0);
    for (int k = 0; k < 20; k++) {
      for (int offsetUs : new int[] {0, 1_500}) { // 200 Hz
        events.append(5_000L * k + offsetUs, 3, 4, true);
        events.append(5_000L * k + offsetUs + 200, 3, 4, false);
      }
    }
    map.add(events);
    assertEquals(200, map.frequencyHz(3, 4, events.lastTimeUs()), 0.1);
  }

  @Test
  void wingPixelsHaveTheFrequencyOfTheBeat() throws IOException {
    List<EventPacket> packets = new ArrayList<>();
    FrequencyMap map;
    try (Scene<?> scene =
        Scenes.named("fly")
            .create(List.of("run.durationS=0.5", "disturbances.manoeuvres.everyS=0"))) {
      map = new FrequencyMap(scene.geometry(), FrequencyMapSettings.defaults());
      StreamHandler consumer =
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              packets.add(packet.copy());
            }

            @Override
            public void notified(StreamNotification notification) {
              // events are all that counts
            }
          };
      while (scene.next(consumer)) {
        // to its end
      }
    }
    packets.forEach(map::add);
    long nowUs = packets.get(packets.size() - 1).lastTimeUs();
    for (int left : new int[] {0, 64}) {
      List<Double> wing = new ArrayList<>();
      for (int y = 0; y < 128; y++) {
        for (int x = left; x < left + 64; x++) {
          double frequency = map.frequencyHz(x, y, nowUs);
          if (!Double.isNaN(frequency)) {
            wing.add(frequency);
          }
        }
      }
      wing.sort(null);
      long near = wing.stream().filter(f -> Math.abs(f - 200) < 15).count();
      assertTrue(wing.size() > 500 && near > 0.8 * wing.size(), near + " of " + wing.size());
    }
  }

  @Test
  void reportHasARowForEachPixelWithAFrequency() {
    FrequencyMapFilter filter =
        new FrequencyMapFilter(SENSOR, new FrequencyMapSettings(5, 1000, 0.05, 4));
    List<PixelFrequency> rows = new ArrayList<>();
    filter.frequencies().subscribe(rows::add);
    EventPacket events = lamp(100, false);
    int before = events.size();
    filter.process(events);
    assertEquals(before, events.size(), "events pass");
    assertEquals(
        List.of(250_000L, 500_000L, 750_000L),
        rows.stream().map(PixelFrequency::timeUs).distinct().toList());
    assertTrue(rows.size() > 3 * 0.9 * SIDE * SIDE / 2, rows.size() + " rows");
    assertTrue(rows.stream().allMatch(row -> row.x() < SIDE / 2));
    assertTrue(EventAddress.x(events.address(0)) < SIDE / 2);
  }

  @Test
  void recordingShorterThanTheTimeBetweenReportsHasOneAtItsEnd() {
    FrequencyMapFilter filter = new FrequencyMapFilter(SENSOR, FrequencyMapSettings.defaults());
    List<PixelFrequency> rows = new ArrayList<>();
    filter.frequencies().subscribe(rows::add);
    EventPacket events = lamp(100, false);
    long lastUs = events.lastTimeUs();
    filter.process(events);
    assertEquals(List.of(), rows);
    filter.notified(new EndOfStream(lastUs));
    assertTrue(rows.size() > SIDE * SIDE / 4, rows.size() + " pixels");
    assertTrue(rows.stream().allMatch(row -> row.timeUs() == lastUs));
    filter.notified(new EndOfStream(lastUs));
    assertEquals(rows.size(), rows.stream().distinct().count(), "no report twice");
  }
}
