package haltere.ui.rendering;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * For each pixel the exponentially fading sum of its events, s = Σ p exp((t - now) / τ), with p = 1
 * or the polarity. Sums are relative to a reference time and scaled when painted, so an event costs
 * one addition.
 */
final class EventSums implements StyleState {
  /** Steps of the colours. */
  private static final int ENTRIES = 1024;

  /** Events of one polarity that always saturate a pixel's intensity. */
  private static final double FULL_INTENSITY = 6;

  /** The reference is moved before weights grow beyond e to this. */
  private static final double MAX_EXPONENT = 20;

  /** A weight serves for events within this share of the time constant. */
  private static final double WEIGHT_TOLERANCE = 1.0 / 256;

  /** Approximate number of sampled pixels for the scale. */
  private static final int SAMPLES = 20_000;

  private static final double SHARE_BELOW_FULL = 0.97;
  private static final double SMOOTHING = 0.2;

  private final int width;
  private final int height;
  private final float[] sums;
  private final float[] samples;
  private final int sampling;
  private final int[] table = new int[ENTRIES];
  private final int[] row;
  private PictureStyle style;
  private long referenceUs;
  private long newestUs;
  private boolean empty = true;
  private double fullCount;

  /** The weight of events at a time, independent of packets. */
  private long weightUs;

  private float weight;

  EventSums(SensorGeometry geometry, PictureStyle style) {
    width = geometry.width();
    height = geometry.height();
    sums = new float[geometry.pixels()];
    // an odd step samples other columns in each row
    sampling = Math.max(1, geometry.pixels() / SAMPLES) | 1;
    samples = new float[geometry.pixels() / sampling + 1];
    row = new int[width];
    configure(style);
  }

  /** Changes the style of the next picture; another mode or time constant clears the sums. */
  @Override
  public void configure(PictureStyle newStyle) {
    if (newStyle.equals(style)) {
      return;
    }
    boolean restarts =
        style == null || newStyle.mode() != style.mode() || newStyle.sharp() != style.sharp();
    if (!restarts && newStyle.timeConstantUs() != style.timeConstantUs()) {
      // sums fade by the old time constant up to the newest event and by the new one from there
      moveReference(newestUs);
    }
    style = newStyle;
    weightUs = Long.MIN_VALUE / 2;
    if (restarts) {
      clear();
    }
    for (int i = 0; i < ENTRIES; i++) {
      double share = (double) i / (ENTRIES - 1);
      table[i] =
          style.mode() == DisplayMode.INTENSITY
              ? Gradient.GREY.colour(share)
              : style.gradient().colour(share);
    }
    ColourRanks.rank(table, style.background());
  }

  @Override
  public void clear() {
    Arrays.fill(sums, 0);
    empty = true;
    fullCount = 0;
    weightUs = Long.MIN_VALUE / 2;
  }

  @Override
  public void beginExposure() {
    clear();
  }

  /** The next picture computes the scale from its own events. */
  @Override
  public void settle() {
    fullCount = 0;
  }

  @Override
  public void packet(EventPacket packet) {
    int size = packet.size();
    if (size == 0) {
      return;
    }
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    if (empty) {
      empty = false;
      referenceUs = times[0];
      newestUs = times[0];
    }
    boolean signed = style.mode() == DisplayMode.INTENSITY;
    double sameUs = style.timeConstantUs() * WEIGHT_TOLERANCE;
    long atUs = weightUs;
    float now = weight;
    for (int i = 0; i < size; i++) {
      if (Math.abs(times[i] - atUs) > sameUs) {
        atUs = times[i];
        now = weight(atUs);
      }
      int address = addresses[i];
      int x = EventAddress.x(address);
      int y = EventAddress.y(address);
      if (x < width && y < height) {
        sums[y * width + x] += signed && !EventAddress.isOn(address) ? -now : now;
      }
    }
    weightUs = atUs;
    weight = now;
    newestUs = times[size - 1];
  }

  private float weight(long timeUs) {
    if (style.sharp()) {
      return 1;
    }
    double exponent = (double) (timeUs - referenceUs) / style.timeConstantUs();
    if (exponent > MAX_EXPONENT) {
      moveReference(timeUs);
      return 1;
    }
    return (float) Math.exp(exponent);
  }

  private void moveReference(long timeUs) {
    if (!style.sharp() && !empty) {
      scale(sums, (float) Math.exp(-(double) (timeUs - referenceUs) / style.timeConstantUs()));
    }
    referenceUs = timeUs;
  }

  private static void scale(float[] values, float factor) {
    for (int i = 0; i < values.length; i++) {
      values[i] *= factor;
    }
  }

  @Override
  public double fullCount() {
    return fullCount;
  }

  @Override
  public void paint(long nowUs, int[] ranked) {
    double present =
        style.sharp() || empty
            ? 1
            : Math.exp(-(double) (nowUs - referenceUs) / style.timeConstantUs());
    boolean signed = style.mode() == DisplayMode.INTENSITY;
    findFullCount(present);
    double range = signed ? 2 * Math.min(FULL_INTENSITY, fullCount) : fullCount;
    float gain = (float) (present * (ENTRIES - 1) / range);
    float middle = signed ? (ENTRIES - 1) / 2f : 0;
    for (int y = 0; y < height; y++) {
      indices(sums, y * width, width, gain, middle, row);
      int to = (height - 1 - y) * width;
      for (int x = 0; x < width; x++) {
        ranked[to + x] = table[row[x]];
      }
    }
  }

  /** Separate, so that the compiler vectorises this loop. */
  private static void indices(
      float[] sums, int from, int width, float gain, float middle, int[] indices) {
    for (int x = 0; x < width; x++) {
      float position = sums[from + x] * gain + middle;
      indices[x] = (int) Math.max(0, Math.min(ENTRIES - 1, position));
    }
  }

  /**
   * Upper bound of all but the most active pixels, so that a hot pixel does not darken all others.
   */
  private void findFullCount(double present) {
    int found = 0;
    for (int i = 0; i < sums.length; i += sampling) {
      float size = Math.abs(sums[i]);
      if (size * present > 0.05) {
        samples[found++] = size;
      }
    }
    double now = 1;
    if (found > 0) {
      int position = Math.min(found - 1, (int) (SHARE_BELOW_FULL * found));
      Arrays.sort(samples, 0, found);
      now = Math.max(1, samples[position] * present);
    }
    fullCount = fullCount == 0 || style.sharp() ? now : fullCount + SMOOTHING * (now - fullCount);
  }
}
