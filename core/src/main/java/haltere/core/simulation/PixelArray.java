package haltere.core.simulation;

import haltere.core.event.EventAddress;

/**
 * The pixels of an event sensor, each solved exactly between two changes of its light.
 *
 * <p>The photoreceptor follows the logarithm of the light with a first order low pass: after a step
 * to the target u its level is v(t) = u + (v0 - u) e<sup>-(t - t0) / tau</sup>. An event is made
 * when the level is a threshold away from the level at the end of the last event's refractory
 * period (without one: a threshold from the last crossing). So a shadow of contrast c that dwells
 * on a pixel for a time d takes its level down by c (1 - e<sup>-d / tau</sup>) and no further: fast
 * edges make fewer events than slow ones.
 *
 * <p>Light is relative to the bright background, whose level is 0. Times are in microseconds since
 * the beginning. Thread rule: one thread at a time.
 */
public final class PixelArray {
  private static final double LEAST_THRESHOLD_SHARE = 0.25;

  // what is known of a pixel lies together, a cache line each
  private static final int FIELDS = 8;
  private static final int LEVEL = 0;
  private static final int TARGET = 1;
  private static final int REFERENCE = 2;
  private static final int AT_US = 3;
  private static final int BLIND_UNTIL_US = 4;
  private static final int OFF_THRESHOLD = 5;
  private static final int ON_THRESHOLD = 6;
  private static final int IS_BUSY = 7;

  private final EventMerger merger;
  private final int width;
  private final long seed;
  private double tauUs;
  private double refractoryUs;
  private final double[] state;
  private final int[] busy;
  private int busyCount;

  /**
   * Pixels in bright light.
   *
   * @param settings thresholds, bandwidth and refractory period
   * @param sensor its size
   * @param seed for the mismatch of the thresholds
   * @param merger takes the events
   */
  public PixelArray(PixelSettings settings, SensorSettings sensor, long seed, EventMerger merger) {
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
    double least = LEAST_THRESHOLD_SHARE * settings.threshold();
    for (int p = 0; p < state.length; p += FIELDS) {
      state[p + OFF_THRESHOLD] =
          ratio
              * Math.max(least, settings.threshold() + settings.thresholdSd() * random.gaussian());
      state[p + ON_THRESHOLD] =
          Math.max(least, settings.threshold() + settings.thresholdSd() * random.gaussian())
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
  public void tune(PixelSettings settings, double balance, double timeUs) {
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
   * Sets a pixel to a light it has had for long: no event.
   *
   * @param pixel row times width plus column
   * @param light natural logarithm, 0 of the background
   */
  public void settle(int pixel, double light) {
    int p = pixel * FIELDS;
    state[p + LEVEL] = light;
    state[p + TARGET] = light;
    state[p + REFERENCE] = light;
  }

  /** Takes the light as it is for light that every pixel has had for long: no event. */
  public void settleAll() {
    for (int pixel = 0; pixel < busy.length; pixel++) {
      settle(pixel, state[pixel * FIELDS + TARGET]);
      state[pixel * FIELDS + IS_BUSY] = 0;
    }
    busyCount = 0;
  }

  /**
   * The time up to which a pixel has been computed.
   *
   * @param pixel row times width plus column
   * @return microseconds since the beginning
   */
  public double computedUntilUs(int pixel) {
    return state[pixel * FIELDS + AT_US];
  }

  /**
   * Changes the light on a pixel.
   *
   * @param pixel row times width plus column
   * @param timeUs when; not before the pixel's last change
   * @param change of the natural logarithm of the light
   */
  public void change(int pixel, double timeUs, double change) {
    int p = pixel * FIELDS;
    advance(pixel, p, timeUs);
    state[p + TARGET] += change;
    if (state[p + IS_BUSY] == 0 && canFire(p, timeUs)) {
      state[p + IS_BUSY] = 1;
      busy[busyCount++] = pixel;
    }
  }

  /**
   * Makes all events before a time, so that none is added before it later on.
   *
   * @param timeUs microseconds since the beginning
   */
  public void advanceAll(double timeUs) {
    int kept = 0;
    for (int i = 0; i < busyCount; i++) {
      int pixel = busy[i];
      int p = pixel * FIELDS;
      advance(pixel, p, timeUs);
      if (canFire(p, timeUs)) {
        busy[kept++] = pixel;
      } else {
        state[p + IS_BUSY] = 0;
      }
    }
    busyCount = kept;
  }

  private boolean canFire(int p, double timeUs) {
    double target = state[p + TARGET];
    double reference = state[p + REFERENCE];
    return timeUs <= state[p + BLIND_UNTIL_US]
        || target <= reference - state[p + OFF_THRESHOLD]
        || target >= reference + state[p + ON_THRESHOLD];
  }

  private double after(double from, double to, double durationUs) {
    return tauUs == 0 ? to : to + (from - to) * Exponential.decay(durationUs / tauUs);
  }

  private void advance(int pixel, int p, double untilUs) {
    double t = state[p + AT_US];
    if (untilUs <= t) {
      return;
    }
    double v = state[p + LEVEL];
    double u = state[p + TARGET];
    double end = after(v, u, untilUs - t);
    double blindUntil = state[p + BLIND_UNTIL_US];
    state[p + AT_US] = untilUs;
    state[p + LEVEL] = end;
    if (t <= blindUntil) {
      if (untilUs <= blindUntil) {
        return;
      }
      v = after(v, u, blindUntil - t);
      t = blindUntil;
      state[p + REFERENCE] = v;
    }
    // the level runs straight from v at t to its end: does it cross a border on the way?
    while (true) {
      double reference = state[p + REFERENCE];
      boolean on = end > reference;
      double border =
          on ? reference + state[p + ON_THRESHOLD] : reference - state[p + OFF_THRESHOLD];
      if (on ? end < border : end > border) {
        return;
      }
      double crossing = t + timeTo(v, border, u, on);
      int y = pixel / width;
      merger.add(crossing, EventAddress.pack(pixel - y * width, y, on));
      t = crossing;
      v = tauUs == 0 ? u : border;
      if (refractoryUs == 0) {
        state[p + REFERENCE] = border;
        continue;
      }
      blindUntil = crossing + refractoryUs;
      state[p + BLIND_UNTIL_US] = blindUntil;
      if (blindUntil >= untilUs) {
        return;
      }
      v = after(v, u, refractoryUs);
      t = blindUntil;
      state[p + REFERENCE] = v;
    }
  }

  /** Solves u + (v - u) e^(-t / tau) = border for t; 0 where the level is there already. */
  private double timeTo(double v, double border, double u, boolean on) {
    if (tauUs == 0 || (on ? v >= border : v <= border)) {
      return 0;
    }
    double share = (border - u) / (v - u);
    return share < 1e-15 ? 0 : -tauUs * Exponential.log(share);
  }
}
