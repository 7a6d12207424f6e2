package haltere.core.simulation;

/**
 * The exponential decay e<sup>-x</sup> from a table, within 1e-10 of the function and made of plain
 * arithmetic, so that it is fast and the same on every machine.
 */
final class Decay {
  private static final int PER_UNIT = 256;
  private static final int LIMIT = 40;
  private static final double[] TABLE = new double[LIMIT * PER_UNIT + 1];

  static {
    for (int i = 0; i < TABLE.length; i++) {
      TABLE[i] = StrictMath.exp(-(double) i / PER_UNIT);
    }
  }

  private Decay() {}

  /** e<sup>-x</sup> for x of at least 0; 0 beyond 40. */
  static double of(double x) {
    if (x >= LIMIT) {
      return 0;
    }
    int i = (int) (x * PER_UNIT);
    double d = x - (double) i / PER_UNIT;
    return TABLE[i] * (1 - d * (1 - d * (0.5 - d * (1.0 / 6))));
  }
}
