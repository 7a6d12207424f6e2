package haltere.core.simulation.internal.road;

import haltere.core.event.EventAddress;
import haltere.core.simulation.internal.sensor.EventMerger;
import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The drops of {@link RainSettings}: a Poisson process of short streaks.
 *
 * <p>Thread rule: one thread at a time.
 */
final class RainStreaks {
  private final RainSettings settings;
  private final int width;
  private final int height;
  private final SeededRandom random;
  private double nextUs;

  RainStreaks(RainSettings settings, SensorSettings sensor, long seed) {
    this.settings = settings;
    width = sensor.widthPx();
    height = sensor.heightPx();
    random = new SeededRandom(seed, "rain");
    nextUs = pause();
  }

  private double pause() {
    return settings.streaksPerS() == 0
        ? Double.POSITIVE_INFINITY
        : random.exponential() * 1e6 / settings.streaksPerS();
  }

  /** Makes the streaks that begin before a time, microseconds since the beginning. */
  void addUntil(double untilUs, EventMerger merger) {
    while (nextUs < untilUs) {
      addStreak(merger);
      nextUs += pause();
    }
  }

  private void addStreak(EventMerger merger) {
    double usPerPx = 1e6 / (settings.speedPxS() * random.between(0.7, 1.3));
    int length = (int) Math.ceil(settings.lengthPx() * random.between(0.5, 1.5));
    double fromX = random.between(0, width);
    int fromY = random.below(height + length);
    for (int i = 0; i < length; i++) {
      int x = (int) Math.floor(fromX + i * settings.slant());
      int y = fromY - i;
      if (x >= 0 && x < width && y >= 0 && y < height) {
        double atUs = nextUs + (i + random.nextDouble()) * usPerPx;
        merger.add(atUs, EventAddress.pack(x, y, true));
        merger.add(atUs + 1.5 * usPerPx, EventAddress.pack(x, y, false));
      }
    }
  }
}
