package haltere.testing.wings;

import java.util.function.DoubleUnaryOperator;

/**
 * Errors of an angle over the phase of the stroke: what repeats from beat to beat is the bias that
 * a model of the stroke lacks.
 */
final class PhaseErrors {
  static final int BINS = 24;

  private final double[] sum = new double[BINS];
  private final long[] count = new long[BINS];
  private double squares;
  private long rows;

  void add(double phaseRad, double error) {
    int bin = (int) Math.min(BINS - 1, phaseRad / (2 * Math.PI) * BINS);
    sum[bin] += error;
    count[bin]++;
    squares += error * error;
    rows++;
  }

  static double phaseRad(int bin) {
    return 2 * Math.PI * (bin + 0.5) / BINS;
  }

  /** Mean error in a bin; NaN if there was none. */
  double meanRad(int bin) {
    return sum[bin] / count[bin];
  }

  long count(int bin) {
    return count[bin];
  }

  /** Mean over the cycle: a heading or a hinge that is off. */
  double constantRad() {
    return weighted(phase -> 1);
  }

  /** Part that goes with the stroke angle: an amplitude that is off. */
  double withAngleRad() {
    return 2 * weighted(Math::sin);
  }

  /** Part that goes with the speed of the wing, negative where the estimate is late. */
  double withSpeedRad() {
    return 2 * weighted(Math::cos);
  }

  private double weighted(DoubleUnaryOperator weight) {
    double all = 0;
    int bins = 0;
    for (int bin = 0; bin < BINS; bin++) {
      if (count[bin] > 0) {
        all += meanRad(bin) * weight.applyAsDouble(phaseRad(bin));
        bins++;
      }
    }
    return all / bins;
  }

  /** Root mean square of all that repeats from beat to beat but the constant. */
  double repeatingRad() {
    double all = 0;
    for (int bin = 0; bin < BINS; bin++) {
      all += count[bin] == 0 ? 0 : count[bin] * meanRad(bin) * meanRad(bin);
    }
    return Math.sqrt(Math.max(0, all / rows - constantRad() * constantRad()));
  }

  /** Root mean square of what does not repeat. */
  double remainderRad() {
    double repeating = repeatingRad();
    double constant = constantRad();
    return Math.sqrt(Math.max(0, squares / rows - repeating * repeating - constant * constant));
  }
}
