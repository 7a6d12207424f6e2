package haltere.core.simulation.internal.sensor;

/**
 * The exponential decay and the natural logarithm from tables, made of plain arithmetic, so that
 * they are fast and the same on every machine.
 */
final class Exponential {
  private static final int PER_UNIT = 256;
  private static final int LIMIT = 40;
  private static final double[] DECAY = new double[LIMIT * PER_UNIT + 1];

  private static final int MANTISSA_BITS = 10;
  private static final double LN2 = StrictMath.log(2);
  private static final double[] LOG = new double[1 << MANTISSA_BITS];
  private static final double[] INVERSE = new double[1 << MANTISSA_BITS];

  static {
    for (int i = 0; i < DECAY.length; i++) {
      DECAY[i] = StrictMath.exp(-(double) i / PER_UNIT);
    }
    for (int i = 0; i < LOG.length; i++) {
      double middle = 1 + (i + 0.5) / LOG.length;
      LOG[i] = StrictMath.log(middle);
      INVERSE[i] = 1 / middle;
    }
  }

  private Exponential() {}

  /** e<sup>-x</sup> for x of at least 0, within 1e-11; 0 beyond 40. */
  static double decay(double x) {
    if (x >= LIMIT) {
      return 0;
    }
    int i = (int) (x * PER_UNIT);
    double d = x - (double) i / PER_UNIT;
    return DECAY[i] * (1 - d * (1 - d * (0.5 - d * (1.0 / 6))));
  }

  /** ln x for x greater than 0 and not subnormal, within 1e-13 of its value or of 1. */
  static double log(double x) {
    long bits = Double.doubleToRawLongBits(x);
    int exponent = (int) (bits >>> 52) - 1023;
    int i = (int) (bits >>> (52 - MANTISSA_BITS)) & (LOG.length - 1);
    double mantissa = Double.longBitsToDouble(bits & 0x000fffffffffffffL | 0x3ff0000000000000L);
    double d = mantissa * INVERSE[i] - 1;
    return exponent * LN2 + LOG[i] + d * (1 - d * (0.5 - d * (1.0 / 3 - d * 0.25)));
  }
}
