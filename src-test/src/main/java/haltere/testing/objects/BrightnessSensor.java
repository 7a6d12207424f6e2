package haltere.testing.objects;

import haltere.core.event.SensorGeometry;
import haltere.testing.EventList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Turns a picture of sprites into events: a pixel makes one each time its logarithmic brightness
 * has changed by its threshold since its last one (Lichtsteiner, Posch and Delbruck, 2008), at a
 * time interpolated between two pictures. Thread rule: one thread at a time.
 */
final class BrightnessSensor {
  /** Usual threshold, a change of brightness by 28 %. */
  static final double THRESHOLD = 0.25;

  /** Standard deviation of the thresholds of pixels, as a share. */
  private static final double MISMATCH = 0.1;

  /** Maximum motion of a sprite between two pictures, pixels. */
  private static final double STEP_PX = 0.8;

  private static final double LONGEST_STEP_S = 0.005;

  private final SensorGeometry geometry;
  private final SplittableRandom random;
  private final double[] threshold;
  private final double[] reference;
  private final double[] before;
  private final double[] now;
  private final boolean[] hidden;
  private double lossShare;
  private final double jitterUs;

  BrightnessSensor(SensorGeometry geometry, SplittableRandom random) {
    this.geometry = geometry;
    this.random = random;
    int n = geometry.pixels();
    threshold = new double[n];
    reference = new double[n];
    before = new double[n];
    now = new double[n];
    hidden = new boolean[n];
    for (int i = 0; i < n; i++) {
      threshold[i] = THRESHOLD * Math.max(0.5, 1 + MISMATCH * random.nextGaussian());
      reference[i] = random.nextDouble(-threshold[i], threshold[i]);
    }
    lossShare = random.nextDouble(0, 0.2);
    jitterUs = random.nextDouble(50, 500);
  }

  /** Sets the share of events that are lost at random, as by pixels that are too slow. */
  void lose(double share) {
    lossShare = share;
  }

  /** Puts an occluder before all sprites. */
  void hide(Box box) {
    Pixels pixels = new Pixels(box);
    for (int y = pixels.y0; y <= pixels.y1; y++) {
      for (int x = pixels.x0; x <= pixels.x1; x++) {
        hidden[y * geometry.width() + x] = true;
      }
    }
  }

  boolean isHidden(int x, int y) {
    return hidden[y * geometry.width() + x];
  }

  /** Pixels of a box and one around it, in the picture. */
  private final class Pixels {
    final int x0;
    final int x1;
    final int y0;
    final int y1;

    Pixels(Box box) {
      x0 = (int) Math.max(0, Math.floor(box.x0() - 1));
      x1 = (int) Math.min(geometry.width() - 1, Math.ceil(box.x1() + 1));
      y0 = (int) Math.max(0, Math.floor(box.y0() - 1));
      y1 = (int) Math.min(geometry.height() - 1, Math.ceil(box.y1() + 1));
    }

    void fill(double level) {
      for (int y = y0; y <= y1 && x0 <= x1; y++) {
        Arrays.fill(now, y * geometry.width() + x0, y * geometry.width() + x1 + 1, level);
      }
    }

    void paint(Sprite sprite) {
      for (int y = y0; y <= y1; y++) {
        for (int x = x0; x <= x1; x++) {
          int i = y * geometry.width() + x;
          now[i] = sprite.over(now[i], x, y);
        }
      }
    }
  }

  /** Shows sprites, the first one at the back, from 0 to a time. */
  void show(List<Sprite> sprites, double durationS, EventList events) {
    double fastest =
        sprites.stream().mapToDouble(sprite -> sprite.motion().maxSpeed()).max().orElse(1);
    double stepS = Math.min(LONGEST_STEP_S, STEP_PX / fastest);
    Box[] last = new Box[sprites.size()];
    Box[] changed = new Box[sprites.size()];
    for (int step = 0; step * stepS < durationS; step++) {
      double s = step * stepS;
      for (int k = 0; k < changed.length; k++) {
        Box box = sprites.get(k).box(s);
        changed[k] = last[k] == null ? box : box.with(last[k]);
        last[k] = box;
        new Pixels(changed[k]).fill(0);
      }
      for (int k = 0; k < changed.length; k++) {
        Sprite sprite = sprites.get(k);
        sprite.moveTo(s);
        new Pixels(last[k]).paint(sprite);
      }
      for (Box box : changed) {
        changePixels(new Pixels(box), s - stepS, stepS, events);
      }
    }
  }

  private void changePixels(Pixels pixels, double fromS, double stepS, EventList events) {
    for (int y = pixels.y0; y <= pixels.y1; y++) {
      for (int x = pixels.x0; x <= pixels.x1; x++) {
        int i = y * geometry.width() + x;
        if (now[i] != before[i]) {
          change(x, y, i, fromS, stepS, events);
          before[i] = now[i];
        }
      }
    }
  }

  /** Makes the events of a pixel whose brightness has changed; none in the first picture. */
  private void change(int x, int y, int i, double fromS, double stepS, EventList events) {
    if (fromS < 0) {
      reference[i] += now[i];
      return;
    }
    if (hidden[i]) {
      return;
    }
    double sign = Math.signum(now[i] - before[i]);
    while (sign * (now[i] - reference[i]) >= threshold[i]) {
      reference[i] += sign * threshold[i];
      if (random.nextDouble() >= lossShare) {
        double share = (reference[i] - before[i]) / (now[i] - before[i]);
        double s = fromS + stepS * Math.max(0, Math.min(1, share));
        double delayUs = -jitterUs * Math.log(1 - random.nextDouble());
        events.add((long) Math.max(0, s * 1e6 + delayUs), x, y, sign > 0);
      }
    }
  }

  /** Pixels of a disc that get brighter and darker periodically, as a lamp on the mains does. */
  void flicker(Box lamp, double hz, int eventsEachHalf, double durationS, EventList events) {
    for (int half = 0; half < durationS * 2 * hz; half++) {
      double fromUs = half / (2 * hz) * 1e6;
      boolean brighter = half % 2 == 0;
      Pixels pixels = new Pixels(lamp);
      for (int y = pixels.y0; y <= pixels.y1; y++) {
        for (int x = pixels.x0; x <= pixels.x1; x++) {
          boolean lit = Matching.CENTRE.distance(lamp, x, y) <= 1 && !isHidden(x, y);
          for (int n = 0; lit && n < eventsEachHalf; n++) {
            if (random.nextDouble() >= lossShare) {
              double share = random.nextDouble();
              events.add((long) (fromUs + share * 0.4e6 / hz), x, y, brighter);
            }
          }
        }
      }
    }
  }

  /** Noise of all pixels and of some hot ones. */
  void noise(double noiseHz, int hotPixels, double hotHz, double durationS, EventList events) {
    addNoise(noiseHz * geometry.pixels(), durationS, events, null);
    int[] hot = new int[hotPixels];
    Arrays.setAll(hot, i -> random.nextInt(geometry.pixels()));
    if (hotPixels > 0) {
      addNoise(hotHz * hotPixels, durationS, events, hot);
    }
  }

  private void addNoise(double rateHz, double durationS, EventList events, int[] pixels) {
    double s = 0;
    while (true) {
      s -= Math.log(1 - random.nextDouble()) / rateHz;
      if (s >= durationS) {
        return;
      }
      int pixel =
          pixels == null
              ? random.nextInt(geometry.pixels())
              : pixels[random.nextInt(pixels.length)];
      events.add(
          (long) (s * 1e6),
          pixel % geometry.width(),
          pixel / geometry.width(),
          random.nextBoolean());
    }
  }
}
