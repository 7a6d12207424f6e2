package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.SceneRuns;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import org.junit.jupiter.api.Test;

/** Noise has the configured rates, within statistical bounds. */
class BackgroundNoiseTest {
  private static final int PIXELS = 128 * 128;

  private static void assertRate(double expected, int counted) {
    assertEquals(expected, counted, 4 * Math.sqrt(expected) + 1);
  }

  @Test
  void shotNoiseHasItsRateAndBalancedPolarities() {
    EventPacket events = SceneRuns.events(SceneRuns.empty("noise.shotHz=5"), 4);

    assertRate(5 * 4 * PIXELS, events.size());
    assertRate(5 * 2 * PIXELS, SceneRuns.count(events, events::isOn));
  }

  @Test
  void shotNoiseIsUniformOverPixelsAndTime() {
    EventPacket events = SceneRuns.events(SceneRuns.empty("noise.shotHz=5"), 4);
    int[] places = new int[1024];
    int[] times = new int[400];
    for (int i = 0; i < events.size(); i++) {
      places[events.y(i) / 4 * 32 + events.x(i) / 4]++;
      times[(int) (events.timeUs(i) / 10_000)]++;
    }

    assertEvenlySpread(places, events.size());
    assertEvenlySpread(times, events.size());
  }

  /** Chi-square within four standard deviations of its mean. */
  private static void assertEvenlySpread(int[] counts, int total) {
    double expected = total / (double) counts.length;
    double chiSquare = 0;
    for (int count : counts) {
      chiSquare += (count - expected) * (count - expected) / expected;
    }
    int freedom = counts.length - 1;
    assertEquals(freedom, chiSquare, 4 * Math.sqrt(2.0 * freedom));
  }

  @Test
  void leakMakesOnlyOnEventsAndVariesBetweenPixels() {
    EventPacket events =
        SceneRuns.events(SceneRuns.empty("noise.leakHz=5", "noise.leakSpreadDecades=0.2"), 4);
    int[] counts = new int[PIXELS];
    for (int i = 0; i < events.size(); i++) {
      assertTrue(events.isOn(i));
      counts[events.y(i) * 128 + events.x(i)]++;
    }
    double mean = events.size() / (double) PIXELS;
    double variance = 0;
    for (int count : counts) {
      variance += (count - mean) * (count - mean) / PIXELS;
    }

    assertRate(5 * 4 * PIXELS, events.size());
    // Poisson within a pixel, log-normal over pixels
    double sigma = 0.2 * Math.log(10);
    double spread = Math.expm1(sigma * sigma) * mean * mean;
    assertEquals(mean + spread, variance, 0.05 * (mean + spread));
  }

  @Test
  void hotPixelsFireAtTheirRate() {
    FlySceneSettings settings = SceneRuns.empty("noise.hotPixels=6", "noise.hotRateHz=500");
    EventPacket events = SceneRuns.events(settings, 4);
    int[] counts = new int[PIXELS];
    for (int i = 0; i < events.size(); i++) {
      counts[events.y(i) * 128 + events.x(i)]++;
    }
    int[] hot =
        new BackgroundNoise(settings.noise(), settings.sensor(), settings.run().seed()).hotPixels();

    assertEquals(6, hot.length);
    int there = 0;
    for (int pixel : hot) {
      assertRate(2000, counts[pixel]);
      there += counts[pixel];
    }
    assertEquals(events.size(), there);
  }

  @Test
  void sceneWithoutNoiseAndWingsHasNoEvents() {
    assertTrue(SceneRuns.events(SceneRuns.empty(), 1).isEmpty());
  }
}
