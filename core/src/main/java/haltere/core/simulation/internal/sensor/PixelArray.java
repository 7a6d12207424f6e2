package haltere.core.simulation.internal.sensor;

/**
 * Pixels that are solved exactly between two changes of their light.
 *
 * <p>The photoreceptor follows the logarithm of the light with a first order low pass: after a step
 * to the target u its level is v(t) = u + (v0 - u) e<sup>-(t - t0) / tau</sup>. So a shadow of
 * contrast c that dwells on a pixel for a time d lowers its level by c (1 - e<sup>-d / tau</sup>)
 * at most: fast edges make fewer events than slow ones.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class PixelArray extends SensorPixels {
  /**
   * Pixels in bright light.
   *
   * @param settings thresholds, bandwidth and refractory period
   * @param sensor its size
   * @param seed for the mismatch of the thresholds
   * @param merger takes the events
   */
  public PixelArray(PixelSettings settings, SensorSettings sensor, long seed, EventMerger merger) {
    super(settings, sensor, seed, merger);
  }

  /**
   * Sets the settled light of a pixel, without an event.
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

  /** Settles all pixels at their present light, without an event. */
  public void settleAll() {
    for (int p = 0; p < state.length; p += FIELDS) {
      settle(p / FIELDS, state[p + TARGET]);
    }
    rest();
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
    if (canFire(p, timeUs)) {
      wake(pixel);
    }
  }

  @Override
  boolean canFire(int p, double timeUs) {
    double target = state[p + TARGET];
    double reference = state[p + REFERENCE];
    return timeUs <= state[p + BLIND_UNTIL_US]
        || target <= reference - state[p + OFF_THRESHOLD]
        || target >= reference + state[p + ON_THRESHOLD];
  }

  private double after(double from, double to, double durationUs) {
    return tauUs == 0 ? to : to + (from - to) * Exponential.decay(durationUs / tauUs);
  }

  @Override
  void advance(int pixel, int p, double untilUs) {
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
    // The level is monotonic from v at t to its end: does it cross a threshold?
    while (true) {
      double reference = state[p + REFERENCE];
      boolean on = end > reference;
      double border =
          on ? reference + state[p + ON_THRESHOLD] : reference - state[p + OFF_THRESHOLD];
      if (on ? end < border : end > border) {
        return;
      }
      double crossing = t + timeTo(v, border, u, on);
      fire(pixel, crossing, on);
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
