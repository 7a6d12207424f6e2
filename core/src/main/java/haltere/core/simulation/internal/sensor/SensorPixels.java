package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventAddress;

/**
 * The pixels of an event sensor after their photoreceptors. Each compares its level with the level
 * at the end of its last event's refractory period (without one: a threshold from the last
 * crossing). A subclass defines the response of the level to light.
 *
 * <p>Light is relative to the bright background, whose level is 0; levels are natural logarithms.
 * Times are in microseconds since the beginning. Thread rule: one thread at a time.
 */
abstract class SensorPixels {
  private static final double MIN_THRESHOLD_SHARE = 0.25;

  // The state of a pixel is one cache line.
  static final int FIELDS = 8;
  static final int LEVEL = 0;
  static final int TARGET = 1;
  static final int REFERENCE = 2;
  static final int AT_US = 3;
  static final int BLIND_UNTIL_US = 4;
  static final int OFF_THRESHOLD = 5;
  static final int ON_THRESHOLD = 6;
  private static final int IS_BUSY = 7;

  final double[] state;
  double tauUs;
  double refractoryUs;
  private final EventMerger merger;
  private final int width;
  private final long seed;
  private final int[] busy;
  private int busyCount;

  /** Pixels in bright light; the seed is for the mismatch of the thresholds. */
  SensorPixels(PixelSettings settings, SensorSettings sensor, long seed, EventMerger merger) {
    this.merger = merger;
    width = sensor.widthPx();
    int pixels = width * sensor.heightPx();
    this.seed = seed;
    state = new double[pixels * FIELDS];
    busy = new int[pixels];
    for (int p = 0; p < state.length; p += FIELDS) {
      state[p + BLIND_UNTIL_US] = -1;
    }
    set(settings, 0);
  }

  private void set(PixelSettings settings, double balance) {
    tauUs = settings.bandwidthHz() == 0 ? 0 : 1e6 / (2 * Math.PI * settings.bandwidthHz());
    refractoryUs = settings.refractoryUs();
    double ratio = StrictMath.pow(2, balance);
    SeededRandom random = new SeededRandom(seed, "thresholds");
    double minThreshold = MIN_THRESHOLD_SHARE * settings.threshold();
    for (int p = 0; p < state.length; p += FIELDS) {
      state[p + OFF_THRESHOLD] =
          ratio
              * Math.max(
                  minThreshold, settings.threshold() + settings.thresholdSd() * random.gaussian());
      state[p + ON_THRESHOLD] =
          Math.max(minThreshold, settings.threshold() + settings.thresholdSd() * random.gaussian())
              / ratio;
    }
  }

  /**
   * Changes the pixels from a time on. A pixel whose level is a new threshold away from that of its
   * last event takes its level for the last event's, so that the change makes no event of its own.
   *
   * @param settings new thresholds, bandwidth and refractory period
   * @param balance as {@link SensorTuning#balance()}
   * @param timeUs not before any change of the light so far
   */
  public final void tune(PixelSettings settings, double balance, double timeUs) {
    advanceAll(timeUs);
    for (int pixel = 0; pixel < busy.length; pixel++) {
      advance(pixel, pixel * FIELDS, timeUs);
    }
    set(settings, balance);
    busyCount = 0;
    for (int pixel = 0; pixel < busy.length; pixel++) {
      int p = pixel * FIELDS;
      double level = state[p + LEVEL];
      double reference = state[p + REFERENCE];
      if (level <= reference - state[p + OFF_THRESHOLD]
          || level >= reference + state[p + ON_THRESHOLD]) {
        state[p + REFERENCE] = level;
      }
      boolean active = canFire(p, timeUs);
      state[p + IS_BUSY] = active ? 1 : 0;
      if (active) {
        busy[busyCount++] = pixel;
      }
    }
  }

  /**
   * The time up to which a pixel has been computed.
   *
   * @param pixel row times width plus column
   * @return microseconds since the beginning
   */
  public final double computedUntilUs(int pixel) {
    return state[pixel * FIELDS + AT_US];
  }

  /**
   * Makes all events before a time; none is added before it afterwards.
   *
   * @param timeUs microseconds since the beginning
   */
  public final void advanceAll(double timeUs) {
    int count = 0;
    for (int i = 0; i < busyCount; i++) {
      int pixel = busy[i];
      int p = pixel * FIELDS;
      advance(pixel, p, timeUs);
      if (canFire(p, timeUs)) {
        busy[count++] = pixel;
      } else {
        state[p + IS_BUSY] = 0;
      }
    }
    busyCount = count;
  }

  /** Marks a pixel that may fire, for {@link #advanceAll}. */
  final void wake(int pixel) {
    int p = pixel * FIELDS;
    if (state[p + IS_BUSY] == 0) {
      state[p + IS_BUSY] = 1;
      busy[busyCount++] = pixel;
    }
  }

  /** Marks all pixels as settled: none can fire. */
  final void rest() {
    for (int p = 0; p < state.length; p += FIELDS) {
      state[p + IS_BUSY] = 0;
    }
    busyCount = 0;
  }

  /** Makes an event of a pixel. */
  final void fire(int pixel, double timeUs, boolean on) {
    int y = pixel / width;
    merger.add(timeUs, EventAddress.pack(pixel - y * width, y, on));
  }

  /** Advances a pixel, whose fields begin at p, to a time under its present light. */
  abstract void advance(int pixel, int p, double untilUs);

  /** Whether the pixel whose fields begin at p can make an event without a change of its light. */
  abstract boolean canFire(int p, double timeUs);
}
