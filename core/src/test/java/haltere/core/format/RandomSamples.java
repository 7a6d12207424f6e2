package haltere.core.format;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Samples of all kinds, from a seed. */
public final class RandomSamples {
  private final SplittableRandom random;
  private final SensorGeometry sensor;

  /** Samples of a sensor. */
  public RandomSamples(SensorGeometry sensor, long seed) {
    this.sensor = sensor;
    random = new SplittableRandom(seed);
  }

  /** A frame of a region, of any depth and colour. */
  public Frame frame(long timeUs) {
    int left = random.nextInt(sensor.width());
    int bottom = random.nextInt(sensor.height());
    int width = random.nextInt(1, sensor.width() - left + 1);
    int height = random.nextInt(1, sensor.height() - bottom + 1);
    int channels = random.nextInt(1, 5);
    Frame.Depth[] depths = Frame.Depth.values();
    Frame.Depth depth = depths[random.nextInt(depths.length)];
    byte[] rows = new byte[width * height * channels * depth.bytes()];
    random.nextBytes(rows);
    return new Frame(
        new Frame.Times(timeUs, timeUs + 500, timeUs - 300, timeUs + 9000),
        left,
        bottom,
        width,
        height,
        channels,
        depth,
        rows);
  }

  /** A sample, of a sensor with or without a compass. */
  public InertialSample sample(long timeUs) {
    float[] values = new float[10];
    for (int i = 0; i < values.length; i++) {
      values[i] = i > 6 && timeUs % 2 == 0 ? Float.NaN : (float) random.nextDouble(-500, 500);
    }
    return new InertialSample(
        timeUs, values[0], values[1], values[2], values[3], values[4], values[5], values[6],
        values[7], values[8], values[9]);
  }

  /** An edge on an input. */
  public Trigger edge(long timeUs, int channels) {
    return new Trigger(
        timeUs,
        Trigger.Source.EXTERNAL_INPUT,
        random.nextBoolean() ? Trigger.Edge.RISING : Trigger.Edge.FALLING,
        random.nextInt(channels));
  }

  /** Samples of all kinds, some at the same time. */
  public List<SensorSample> all(int count, long fromUs, int meanStepUs) {
    List<SensorSample> samples = new ArrayList<>();
    long timeUs = fromUs;
    for (int i = 0; i < count; i++) {
      timeUs += random.nextInt(2 * meanStepUs);
      samples.add(
          switch (random.nextInt(8)) {
            case 0 -> frame(timeUs);
            case 1, 2 -> edge(timeUs, 1);
            default -> sample(timeUs);
          });
    }
    return samples;
  }
}
