package haltere.core.format.internal.aedat2;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;

/**
 * Assembles samples from the words of a DAVIS camera: edges on its input; an inertial sample of
 * seven words (acceleration along x, y and z, temperature, rotation about x, y and z); a frame of
 * two words for each pixel, its reset and its signal value.
 *
 * <p>A pixel of a frame is the first minus the second, in 16 bits of which the upper ten are used.
 * Unlike that of events, x of a frame's words is not mirrored. The exposure lasts from the reset to
 * the signal value of the first pixel.
 */
final class DavisSamples implements AedatSampleCursor.SampleAssembly {
  private static final int INERTIAL = 3;
  private static final int SIGNAL = 1;
  private static final int RESET = 0;
  private static final int INERTIAL_WORDS = 7;
  private static final float STEPS = 32_768f;
  private static final float STEPS_PER_DEGREE = 340f;
  private static final float ZERO_STEPS_C = 35f;

  private final SensorGeometry geometry;
  private final InertialRange range;
  private final ViolationCounts violations;
  private final short[] inertial = new short[INERTIAL_WORDS];
  private int inertialWords;
  private PixelSamples samples;

  DavisSamples(SensorGeometry geometry, InertialRange range, ViolationCounts violations) {
    this.geometry = geometry;
    this.range = range;
    this.violations = violations;
  }

  @Override
  public SensorSample take(int word, long timeUs, long offset) {
    if (word >= 0) {
      return trigger(word & 0x3ff, timeUs);
    }
    int type = word >>> 10 & 3;
    if (type == INERTIAL) {
      return inertial(word >>> 28 & 7, (short) (word >>> 12), timeUs, offset);
    }
    return type == RESET || type == SIGNAL ? sample(word, type == SIGNAL, timeUs, offset) : null;
  }

  private static Trigger trigger(int code, long timeUs) {
    Trigger.Edge edge =
        switch (code) {
          case 2 -> Trigger.Edge.RISING;
          case 3 -> Trigger.Edge.FALLING;
          default -> Trigger.Edge.PULSE;
        };
    return new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge, 0);
  }

  private InertialSample inertial(int code, short value, long timeUs, long offset) {
    if (code != inertialWords) {
      violations.add(Violation.INCOMPLETE_SAMPLE, offset);
      inertialWords = 0;
      if (code != 0) {
        return null;
      }
    }
    inertial[inertialWords++] = value;
    if (inertialWords < INERTIAL_WORDS) {
      return null;
    }
    inertialWords = 0;
    float g = range.accelerationG() / STEPS;
    float degS = range.rotationDegS() / STEPS;
    return new InertialSample(
        timeUs,
        inertial[0] * g,
        inertial[1] * g,
        inertial[2] * g,
        inertial[4] * degS,
        inertial[5] * degS,
        inertial[6] * degS,
        inertial[3] / STEPS_PER_DEGREE + ZERO_STEPS_C);
  }

  private Frame sample(int word, boolean signal, long timeUs, long offset) {
    int x = word >>> 12 & 0x3ff;
    int y = word >>> 22 & 0x1ff;
    if (!geometry.contains(x, y)) {
      return null;
    }
    if (samples == null) {
      samples = new PixelSamples(geometry);
    }
    Frame whole = null;
    if (!signal && samples.hasReset(x, y)) {
      // a region of the sensor has fewer samples; the next frame's first sample ends it
      whole = samples.finish();
      if (whole == null) {
        violations.add(Violation.INCOMPLETE_SAMPLE, offset);
      }
      samples.clear();
    }
    if (!samples.add(x, y, signal, word & 0x3ff, timeUs)) {
      violations.add(Violation.INCOMPLETE_SAMPLE, offset);
    }
    if (samples.coversSensor()) {
      whole = samples.finish();
      samples.clear();
    }
    return whole;
  }

  @Override
  public void reset() {
    inertialWords = 0;
    if (samples != null) {
      samples.clear();
    }
  }
}
