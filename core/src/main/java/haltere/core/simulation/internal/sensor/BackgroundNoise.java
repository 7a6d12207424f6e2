package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventAddress;
import java.util.Arrays;

/**
 * Noise events: leak (ON, a rate of its own for each pixel), shot noise (both polarities, all
 * pixels alike) and hot pixels (ON). All are Poisson processes.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class BackgroundNoise {
  private final NoiseSettings settings;
  private final int width;
  private final int pixels;
  private final long seed;
  private final SeededRandom random;
  private final double leakHz;
  private final double shotHz;
  private final double totalHz;
  private NoisyPixels noisy;
  private double nextUs;

  /** Sums of the relative leak rates up to each pixel, and the hot pixels. */
  private record NoisyPixels(double[] leakUpTo, int[] hot) {}

  /**
   * Noise from the beginning.
   *
   * @param settings its rates
   * @param sensor its size
   * @param seed of the scene
   */
  public BackgroundNoise(NoiseSettings settings, SensorSettings sensor, long seed) {
    this(settings, sensor, seed, 0);
  }

  /**
   * Noise from a time on; the same pixels are noisy.
   *
   * @param settings its rates
   * @param sensor its size
   * @param seed of the scene
   * @param fromUs microseconds since the beginning
   */
  public BackgroundNoise(NoiseSettings settings, SensorSettings sensor, long seed, long fromUs) {
    this.settings = settings;
    this.seed = seed;
    width = sensor.widthPx();
    pixels = width * sensor.heightPx();
    random = new SeededRandom(seed, fromUs == 0 ? "noise" : "noise from " + fromUs);
    leakHz = settings.leakHz() * pixels;
    shotHz = settings.shotHz() * pixels;
    totalHz = leakHz + shotHz + settings.hotRateHz() * Math.min(settings.hotPixels(), pixels);
    nextUs = fromUs + pause();
  }

  /** Drawn at the first use, since the truth alone needs no noise. */
  private NoisyPixels noisy() {
    if (noisy == null) {
      noisy = draw();
    }
    return noisy;
  }

  private NoisyPixels draw() {
    SeededRandom positions = new SeededRandom(seed, "noisy pixels");
    double[] leakUpTo = new double[pixels];
    double sum = 0;
    for (int i = 0; i < pixels; i++) {
      sum += StrictMath.pow(10, settings.leakSpreadDecades() * positions.gaussian());
      leakUpTo[i] = sum;
    }
    int[] hot = new int[Math.min(settings.hotPixels(), pixels)];
    boolean[] taken = new boolean[pixels];
    for (int i = 0; i < hot.length; i++) {
      int pixel = positions.below(pixels);
      while (taken[pixel]) {
        pixel = positions.below(pixels);
      }
      taken[pixel] = true;
      hot[i] = pixel;
    }
    return new NoisyPixels(leakUpTo, hot);
  }

  private double pause() {
    return totalHz == 0 ? Double.POSITIVE_INFINITY : random.exponential() * 1e6 / totalHz;
  }

  /**
   * The hot pixels.
   *
   * @return row times width plus column of each
   */
  public int[] hotPixels() {
    return noisy().hot().clone();
  }

  /**
   * Makes the events before a time.
   *
   * @param untilUs microseconds since the beginning
   * @param merger receives them
   */
  public void addUntil(double untilUs, EventMerger merger) {
    while (nextUs < untilUs) {
      double which = random.nextDouble() * totalHz;
      int pixel;
      boolean on = true;
      if (which < leakHz) {
        pixel = leaking(random.nextDouble(), noisy().leakUpTo());
      } else if (which < leakHz + shotHz) {
        pixel = random.below(pixels);
        on = (random.nextLong() & 1) != 0;
      } else {
        int[] hot = noisy().hot();
        pixel = hot[random.below(hot.length)];
      }
      int y = pixel / width;
      merger.add(nextUs, EventAddress.pack(pixel - y * width, y, on));
      nextUs += pause();
    }
  }

  private int leaking(double share, double[] leakUpTo) {
    int found = Arrays.binarySearch(leakUpTo, share * leakUpTo[pixels - 1]);
    return Math.min(pixels - 1, found >= 0 ? found + 1 : -found - 1);
  }
}
