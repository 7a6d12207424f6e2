package haltere.core.simulation.internal.sensor;

import java.util.Arrays;

/**
 * Pixels that low-pass the photocurrent and then take its logarithm, as the circuit does.
 *
 * <p>The current y follows the light I by dy/dt = (I - y) / tau. Where the bandwidth follows the
 * light, tau = tauRef / I with I = 1 for the background: the photocurrent charges the input node
 * (Hu, Liu and Delbruck 2021, section 3; Nozaki and Delbruck 2017). So a dark edge comes later and
 * makes fewer events than the bright edge behind it. A source follower low-passes ln y once more,
 * where the settings have one.
 *
 * <p>Light is linear between changes. The level is computed at instants between which it changes by
 * a quarter of the pixel's threshold, and interpolated linearly: times of events are not on a grid.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class PhotoreceptorArray extends SensorPixels {
  /** Change of the level between two instants at which it is computed, share of the threshold. */
  private static final double STEP_SHARE = 0.25;

  private static final double MIN_STEP_US = 1e-3;

  /** Minimum light, as a share of the background: a photodiode has a dark current. */
  private static final double DARK = 1e-4;

  private final boolean followsLight;
  private final double followerUs;
  private final double[] light;
  private final double[] current;
  private final double[] logCurrent;

  /**
   * Pixels in the light of the background.
   *
   * @param settings thresholds, bandwidth and refractory period
   * @param receptor the photoreceptor
   * @param sensor its size
   * @param seed for the mismatch of the thresholds
   * @param merger takes the events
   */
  public PhotoreceptorArray(
      PixelSettings settings,
      PhotoreceptorSettings receptor,
      SensorSettings sensor,
      long seed,
      EventMerger merger) {
    super(settings, sensor, seed, merger);
    followsLight = receptor.followsLight();
    followerUs = receptor.followerHz() == 0 ? 0 : 1e6 / (2 * Math.PI * receptor.followerHz());
    light = new double[sensor.widthPx() * sensor.heightPx()];
    current = new double[light.length];
    Arrays.fill(light, 1);
    Arrays.fill(current, 1);
    logCurrent = new double[light.length];
  }

  /**
   * Sets the settled light of a pixel, without an event.
   *
   * @param pixel row times width plus column
   * @param newLight as a share of the background
   */
  public void settle(int pixel, double newLight) {
    int p = pixel * FIELDS;
    light[pixel] = Math.max(DARK, newLight);
    current[pixel] = light[pixel];
    logCurrent[pixel] = Exponential.log(light[pixel]);
    state[p + LEVEL] = logCurrent[pixel];
    state[p + REFERENCE] = logCurrent[pixel];
  }

  /**
   * Changes the light on a pixel linearly from a time to another; until then it is constant.
   *
   * @param pixel row times width plus column
   * @param fromUs start of the change; not before the end of the pixel's last change
   * @param toUs end of the change, after its start
   * @param newLight at the end, as a share of the background
   */
  public void change(int pixel, double fromUs, double toUs, double newLight) {
    int p = pixel * FIELDS;
    double to = Math.max(DARK, newLight);
    follow(pixel, p, fromUs, 0);
    follow(pixel, p, toUs, (to - light[pixel]) / (toUs - fromUs));
    light[pixel] = to;
    wake(pixel);
  }

  @Override
  void advance(int pixel, int p, double untilUs) {
    follow(pixel, p, untilUs, 0);
  }

  @Override
  boolean canFire(int p, double timeUs) {
    int pixel = p / FIELDS;
    double target = Exponential.log(light[pixel]);
    // After a source follower, the level may still approach the current.
    double low = Math.min(target, logCurrent[pixel]);
    double high = Math.max(target, logCurrent[pixel]);
    return timeUs <= state[p + BLIND_UNTIL_US]
        || low <= state[p + REFERENCE] - state[p + OFF_THRESHOLD]
        || high >= state[p + REFERENCE] + state[p + ON_THRESHOLD];
  }

  /** Advances a pixel to a time while its light changes by a slope, share per microsecond. */
  private void follow(int pixel, int p, double untilUs, double slope) {
    double t = state[p + AT_US];
    if (t >= untilUs) {
      return;
    }
    double step = STEP_SHARE * Math.min(state[p + OFF_THRESHOLD], state[p + ON_THRESHOLD]);
    double i = light[pixel];
    double y = current[pixel];
    double u = logCurrent[pixel];
    double v = state[p + LEVEL];
    while (t < untilUs) {
      double left = untilUs - t;
      double tau = followsLight ? tauUs / i : tauUs;
      double rate = Math.abs(slope) / i * (tau > left ? left / tau : 1);
      rate += tau == 0 ? 0 : Math.abs(i - y) / (y * tau);
      if (followerUs > 0) {
        rate = Math.max(rate, Math.abs(u - v) / followerUs);
      }
      double h = Math.min(left, Math.max(MIN_STEP_US, step / rate));
      double nextI = i + slope * h;
      double nextY = nextI;
      if (tau > 0) {
        tau = followsLight ? 2 * tauUs / (i + nextI) : tauUs;
        nextY = following(y, i, nextI, h, tau);
      }
      double nextU = Exponential.log(nextY);
      double nextV = followerUs == 0 ? nextU : following(v, u, nextU, h, followerUs);
      double nextT = h == left ? untilUs : t + h;
      compare(pixel, p, t, v, nextT, nextV);
      t = nextT;
      i = nextI;
      y = nextY;
      u = nextU;
      v = nextV;
    }
    state[p + AT_US] = untilUs;
    state[p + LEVEL] = v;
    current[pixel] = y;
    logCurrent[pixel] = u;
  }

  /** Exact response of a first order low pass to a linear input, after a time. */
  private static double following(
      double output, double input, double nextInput, double afterUs, double timeConstantUs) {
    double lag = (nextInput - input) / afterUs * timeConstantUs;
    return nextInput - lag + (output - input + lag) * Exponential.decay(afterUs / timeConstantUs);
  }

  /** Makes the events of a level that is linear between two instants. */
  private void compare(int pixel, int p, double fromUs, double from, double toUs, double to) {
    double t = fromUs;
    double v = from;
    double blindUntil = state[p + BLIND_UNTIL_US];
    while (true) {
      if (t <= blindUntil) {
        if (toUs <= blindUntil) {
          return;
        }
        v = from + (to - from) * (blindUntil - fromUs) / (toUs - fromUs);
        t = blindUntil;
        state[p + REFERENCE] = v;
      }
      double reference = state[p + REFERENCE];
      boolean on = to > reference;
      double border =
          on ? reference + state[p + ON_THRESHOLD] : reference - state[p + OFF_THRESHOLD];
      if (on ? to < border : to > border) {
        return;
      }
      double share = to == v ? 0 : Math.min(1, Math.max(0, (border - v) / (to - v)));
      t += share * (toUs - t);
      v = border;
      fire(pixel, t, on);
      if (refractoryUs == 0) {
        state[p + REFERENCE] = border;
      } else {
        blindUntil = t + refractoryUs;
        state[p + BLIND_UNTIL_US] = blindUntil;
      }
    }
  }
}
