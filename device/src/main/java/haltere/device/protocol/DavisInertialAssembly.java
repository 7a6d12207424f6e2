package haltere.device.protocol;

import haltere.core.event.InertialSample;

/**
 * Assembles an inertial sample from its bytes: x, y and z of the acceleration, the temperature, x,
 * y and z of the rotation, each of 16 bits, the high byte first; disabled groups are missing.
 *
 * <p>Source of the scales: the InvenSense MPU-6050 and MPU-9250, with the ranges stated in the
 * sample.
 */
final class DavisInertialAssembly {
  private static final int VALUES = 7;
  private static final int TEMPERATURE = 3;
  private static final int HAS_ACCELERATION = 0x80;
  private static final int HAS_ROTATION = 0x40;
  private static final int HAS_TEMPERATURE = 0x20;
  private static final float STEPS = 65_536f;
  private static final int MIN_RANGE_G = 4;
  private static final int MIN_RANGE_DEG_S = 500;

  private final DavisLayout layout;
  private final int[] bytes = new int[2 * VALUES];
  private boolean begun;
  private int configuration;
  private int count;

  DavisInertialAssembly(DavisLayout layout) {
    this.layout = layout;
  }

  void begin() {
    begun = true;
    configuration = 0;
    count = 0;
  }

  void breakOff() {
    begun = false;
  }

  void configure(int value) {
    configuration = value;
  }

  void add(int value) {
    if (count < bytes.length) {
      bytes[count] = value;
    }
    count++;
  }

  /** The sample, or null if it is incomplete. */
  InertialSample end(long timeUs) {
    int groups =
        (has(HAS_ACCELERATION) ? 6 : 0)
            + (has(HAS_TEMPERATURE) ? 2 : 0)
            + (has(HAS_ROTATION) ? 6 : 0);
    boolean whole = begun && groups > 0 && count == groups;
    begun = false;
    if (!whole) {
      return null;
    }
    float[] values = new float[VALUES];
    float g = (MIN_RANGE_G << (configuration >> 2 & 3)) / STEPS;
    float degS = (MIN_RANGE_DEG_S << (configuration & 3)) / STEPS;
    int at = 0;
    for (int i = 0; i < VALUES; i++) {
      boolean there =
          i < TEMPERATURE
              ? has(HAS_ACCELERATION)
              : i == TEMPERATURE ? has(HAS_TEMPERATURE) : has(HAS_ROTATION);
      if (there) {
        short raw = (short) (bytes[at] << 8 | bytes[at + 1]);
        at += 2;
        values[i] = i == TEMPERATURE ? celsius(raw) : raw * (i < TEMPERATURE ? g : degS) * sign(i);
      } else {
        values[i] = Float.NaN;
      }
    }
    return new InertialSample(
        timeUs, values[0], values[1], values[2], values[4], values[5], values[6], values[3]);
  }

  private boolean has(int bit) {
    return (configuration & bit) != 0;
  }

  private float celsius(short raw) {
    return layout.wideThermometer() ? raw / 333.87f + 21 : raw / 340f + 35;
  }

  /** Sign of an axis: bits 2, 1 and 0 of the layout are for x, y and z. */
  private int sign(int value) {
    int axis = value < TEMPERATURE ? value : value - TEMPERATURE - 1;
    return (layout.inertialFlips() >> 2 - axis & 1) != 0 ? -1 : 1;
  }
}
