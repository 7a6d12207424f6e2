package haltere.core.simulation;

import haltere.core.event.EventAddress;
import java.util.Arrays;

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
final class PixelArray {
  private static final double LEAST_THRESHOLD_SHARE = 0.25;

  private final EventMerger merger;
  private final int width;
  private final double tauUs;
  private final double refractoryUs;
  private final double[] offThreshold;
  private final double[] onThreshold;
  private final double[] level;
  private final double[] target;
  private final double[] reference;
  private final double[] atUs;
  private final double[] blindUntilUs;
  private final boolean[] isBusy;
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
  PixelArray(PixelSettings settings, SensorSettings sensor, long seed, EventMerger merger) {
    this.merger = merger;
    width = sensor.widthPx();
    int pixels = width * sensor.heightPx();
    tauUs = settings.bandwidthHz() == 0 ? 0 : 1e6 / (2 * Math.PI * settings.bandwidthHz());
    refractoryUs = settings.refractoryUs();
    offThreshold = new double[pixels];
    onThreshold = new double[pixels];
    SeededRandom random = new SeededRandom(seed, "thresholds");
    double least = LEAST_THRESHOLD_SHARE * settings.threshold();
    for (int i = 0; i < pixels; i++) {
      offThreshold[i] =
          Math.max(least, settings.threshold() + settings.thresholdSd() * random.gaussian());
      onThreshold[i] =
          Math.max(least, settings.threshold() + settings.thresholdSd() * random.gaussian());
    }
    level = new double[pixels];
    target = new double[pixels];
    reference = new double[pixels];
    atUs = new double[pixels];
    blindUntilUs = new double[pixels];
    Arrays.fill(blindUntilUs, -1);
    isBusy = new boolean[pixels];
    busy = new int[pixels];
  }

  /** Sets a pixel to a light it has had for long: no event. */
  void settle(int pixel, double light) {
    level[pixel] = light;
    target[pixel] = light;
    reference[pixel] = light;
  }

  /**
   * Changes the light on a pixel.
   *
   * @param pixel row times width plus column
   * @param timeUs when; not before the pixel's last change
   * @param change of the natural logarithm of the light
   */
  void change(int pixel, double timeUs, double change) {
    advance(pixel, timeUs);
    target[pixel] += change;
    if (!isBusy[pixel] && canFire(pixel, timeUs)) {
      isBusy[pixel] = true;
      busy[busyCount++] = pixel;
    }
  }

  /** Takes the light as it is for light that every pixel has had for long: no event. */
  void settleAll() {
    for (int pixel = 0; pixel < target.length; pixel++) {
      settle(pixel, target[pixel]);
      isBusy[pixel] = false;
    }
    busyCount = 0;
  }

  /** The time up to which a pixel has been computed. */
  double computedUntilUs(int pixel) {
    return atUs[pixel];
  }

  /** Makes all events before a time, so that none is added before it later on. */
  void advanceAll(double timeUs) {
    int kept = 0;
    for (int i = 0; i < busyCount; i++) {
      int pixel = busy[i];
      advance(pixel, timeUs);
      if (canFire(pixel, timeUs)) {
        busy[kept++] = pixel;
      } else {
        isBusy[pixel] = false;
      }
    }
    busyCount = kept;
  }

  private boolean canFire(int pixel, double timeUs) {
    double step = target[pixel] - reference[pixel];
    return timeUs < blindUntilUs[pixel]
        || step <= -offThreshold[pixel]
        || step >= onThreshold[pixel];
  }

  private double after(double from, double to, double durationUs) {
    return tauUs == 0 ? to : to + (from - to) * Decay.of(durationUs / tauUs);
  }

  private void advance(int pixel, double untilUs) {
    double t = atUs[pixel];
    if (untilUs <= t) {
      return;
    }
    double v = level[pixel];
    double u = target[pixel];
    double blind = blindUntilUs[pixel];
    if (t < blind) {
      if (untilUs <= blind) {
        level[pixel] = after(v, u, untilUs - t);
        atUs[pixel] = untilUs;
        return;
      }
      v = after(v, u, blind - t);
      t = blind;
      reference[pixel] = v;
    }
    while (true) {
      boolean on = u > reference[pixel];
      double border =
          on ? reference[pixel] + onThreshold[pixel] : reference[pixel] - offThreshold[pixel];
      if (on ? u < border : u > border) {
        break;
      }
      double crossing = t + timeTo(v, border, u, on);
      if (crossing >= untilUs) {
        break;
      }
      int y = pixel / width;
      merger.add(crossing, EventAddress.pack(pixel - y * width, y, on));
      t = crossing;
      v = border;
      if (tauUs == 0) {
        v = u;
      }
      if (refractoryUs > 0) {
        blind = crossing + refractoryUs;
        blindUntilUs[pixel] = blind;
        if (blind >= untilUs) {
          break;
        }
        v = after(v, u, refractoryUs);
        t = blind;
        reference[pixel] = v;
      } else {
        reference[pixel] = border;
      }
    }
    level[pixel] = after(v, u, untilUs - t);
    atUs[pixel] = untilUs;
  }

  /** Solves u + (v - u) e^(-t / tau) = border for t; 0 where the level is there already. */
  private double timeTo(double v, double border, double u, boolean on) {
    if (tauUs == 0 || (on ? v >= border : v <= border)) {
      return 0;
    }
    return border == u ? Double.POSITIVE_INFINITY : tauUs * StrictMath.log((v - u) / (border - u));
  }
}
