package haltere.filters.wing.stroke;

/**
 * Sine and cosine of one angle, worked out together in about the time of one of them: for filters
 * that need both at every event. Within 4e-16 of the exact ones for angles up to {@link
 * #GREATEST_ANGLE}; beyond that, and of what is not a number, those of {@link Math}.
 *
 * <p>The angle is brought to within a quarter turn about 0 by taking off a multiple of π/2, given
 * in two parts of which the first has 33 bits, so that its multiple is exact (W. J. Cody and W.
 * Waite 1980, "Software Manual for the Elementary Functions"). There the Taylor series up to the
 * powers 15 and 16 is exact to rounding. Its terms are summed in pairs, so that no long chain of
 * operations has to be waited for (G. Estrin 1960).
 *
 * <p>Allocates nothing after its construction. Thread rule: not safe for use by two threads at a
 * time.
 */
final class SineCosine {
  /** Angles either way up to which the fast way is taken, radians. */
  static final double GREATEST_ANGLE = 1e5;

  private static final double QUARTERS_PER_RADIAN = 2 / Math.PI;

  /** π/2 in two parts. */
  private static final double QUARTER = 0x1.921fb544p0;

  private static final double QUARTER_REST = 0x1.0b4611a626331p-34;

  private static final double S3 = -1.0 / 6;
  private static final double S5 = 1.0 / 120;
  private static final double S7 = -1.0 / 5_040;
  private static final double S9 = 1.0 / 362_880;
  private static final double S11 = -1.0 / 39_916_800;
  private static final double S13 = 1.0 / 6_227_020_800L;
  private static final double S15 = -1.0 / 1_307_674_368_000L;
  private static final double C4 = 1.0 / 24;
  private static final double C6 = -1.0 / 720;
  private static final double C8 = 1.0 / 40_320;
  private static final double C10 = -1.0 / 3_628_800;
  private static final double C12 = 1.0 / 479_001_600;
  private static final double C14 = -1.0 / 87_178_291_200L;
  private static final double C16 = 1.0 / 20_922_789_888_000L;

  private double sine;
  private double cosine = 1;

  /** Works both out of radians; of NaN and infinities both are NaN. */
  void of(double angle) {
    if (!(Math.abs(angle) <= GREATEST_ANGLE)) {
      sine = Math.sin(angle);
      cosine = Math.cos(angle);
      return;
    }
    double quarters = Math.rint(angle * QUARTERS_PER_RADIAN);
    double r = angle - quarters * QUARTER - quarters * QUARTER_REST;
    double z = r * r;
    double w = z * z;
    double ww = w * w;
    double sineRest = (S3 + z * S5) + w * (S7 + z * S9) + ww * ((S11 + z * S13) + w * S15);
    double cosineRest = (C4 + z * C6) + w * (C8 + z * C10) + ww * ((C12 + z * C14) + w * C16);
    double s = r + r * z * sineRest;
    double c = 1 - 0.5 * z + w * cosineRest;
    int quarter = (int) quarters;
    if ((quarter & 1) != 0) {
      double exchanged = s;
      s = c;
      c = -exchanged;
    }
    boolean opposite = (quarter & 2) != 0;
    sine = opposite ? -s : s;
    cosine = opposite ? -c : c;
  }

  /** Of the last angle. */
  double sine() {
    return sine;
  }

  double cosine() {
    return cosine;
  }
}
