package haltere.device.model;

import haltere.core.settings.Parameter;
import java.util.List;

/**
 * One bias of a DAVIS chip. A current has a coarse and a fine part: current = full scale of the
 * coarse part times fine / 255. A voltage and the level of a shifted source count in 64ths.
 *
 * @param name the manufacturer's name
 * @param parameter number in the module of biases
 * @param kind layout of its 16 bits
 * @param first coarse part, or voltage, or reference level
 * @param second fine part, or current, or regulator level
 * @param flags the lowest four bits of a current: enabled, N type, normal, not low current
 */
record DavisBias(String name, int parameter, Kind kind, int first, int second, int flags) {
  /** Layout of the 16 bits. */
  enum Kind {
    /** Bits 14..12 coarse, 11..4 fine, 3..0 flags. */
    CURRENT,
    /** Bits 8..6 current, 5..0 voltage. */
    VOLTAGE,
    /** Bits 15..10 regulator, 9..4 reference, 3..0 mode and level. */
    SHIFTED_SOURCE
  }

  private static final double[] FULL_PA = {
    11, 94, 756, 6054, 48_437, 387_500, 3_100_000, 24_800_000
  };
  private static final int FINE = 255;
  private static final int LEVELS = 63;
  private static final int NORMAL = 0xf;

  static DavisBias current(int parameter, String name, int coarse, int fine) {
    return new DavisBias(name, parameter, Kind.CURRENT, coarse, fine, NORMAL);
  }

  static DavisBias current(int parameter, String name, int coarse, int fine, String type) {
    int flags =
        switch (type) {
          case "P" -> NORMAL & ~2;
          case "cascode" -> NORMAL & ~4;
          case "off" -> NORMAL & ~1;
          default -> throw new IllegalArgumentException(type);
        };
    return new DavisBias(name, parameter, Kind.CURRENT, coarse, fine, flags);
  }

  static DavisBias voltage(int parameter, String name, int voltage, int current) {
    return new DavisBias(name, parameter, Kind.VOLTAGE, voltage, current, 0);
  }

  static DavisBias shiftedSource(int parameter, String name) {
    return new DavisBias(name, parameter, Kind.SHIFTED_SOURCE, 1, 33, 0);
  }

  double defaultValue() {
    return kind == Kind.CURRENT ? FULL_PA[first] * second / FINE : first;
  }

  /** The largest value that the chip can set. */
  double max() {
    return kind == Kind.CURRENT ? FULL_PA[FULL_PA.length - 1] : LEVELS;
  }

  Parameter asParameter() {
    boolean current = kind == Kind.CURRENT;
    return new Parameter(
        name,
        double.class,
        current ? "pA" : "1/64",
        0,
        max(),
        current,
        switch (kind) {
          case CURRENT -> "Current of the bias " + name + ".";
          case VOLTAGE -> "Voltage of the bias " + name + ", in 64ths of the supply.";
          case SHIFTED_SOURCE -> "Reference level of the shifted source " + name + ".";
        },
        defaultValue(),
        List.of(),
        "");
  }

  /** The nearest value that the chip can set. */
  double nearest(double value) {
    if (kind != Kind.CURRENT) {
      return Math.rint(value);
    }
    int coarse = coarse(value);
    return FULL_PA[coarse] * fine(value, coarse) / FINE;
  }

  /** The 16 bits for a value. */
  int bits(double value) {
    return switch (kind) {
      case CURRENT -> {
        int coarse = coarse(value);
        yield coarse << 12 | fine(value, coarse) << 4 | flags;
      }
      case VOLTAGE -> second << 6 | (int) Math.rint(value);
      case SHIFTED_SOURCE -> second << 10 | (int) Math.rint(value) << 4;
    };
  }

  /**
   * Coarse part for a value: that of the usual value, else the smallest possible, which has the
   * finest steps.
   */
  private int coarse(double value) {
    if (value == defaultValue()) {
      return first;
    }
    int coarse = 0;
    while (coarse < FULL_PA.length - 1 && FULL_PA[coarse] < value) {
      coarse++;
    }
    return coarse;
  }

  private static int fine(double value, int coarse) {
    return (int) Math.min(FINE, Math.rint(value * FINE / FULL_PA[coarse]));
  }
}
