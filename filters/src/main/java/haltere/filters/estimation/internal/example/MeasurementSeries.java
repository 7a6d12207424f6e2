package haltere.filters.estimation.internal.example;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.ejml.data.DMatrixRMaj;

/** Measurements of one motion, with the noise estimated from them. Immutable. */
public final class MeasurementSeries {
  /** Fewest measurements: twice the unknowns of a weight on a spring. */
  public static final int MIN_SIZE = 8;

  /** Smallest noise of an instrument, in m or m/s²: a picometre, the size of an atom over 100. */
  private static final double MIN_NOISE = 1e-12;

  /** Largest noise, above the radius of the earth, 6e6 m. */
  private static final double MAX_NOISE = 1e7;

  private final List<Measurement> measurements;
  private final DMatrixRMaj noise;

  /**
   * A series.
   *
   * @param measurements at least {@link #MIN_SIZE}, times ascend; all or none have an acceleration
   * @throws IllegalArgumentException if they are too few, do not ascend or never change
   */
  public MeasurementSeries(List<Measurement> measurements) {
    this.measurements = List.copyOf(measurements);
    if (size() < MIN_SIZE) {
      throw new IllegalArgumentException(
          "there are " + size() + " measurements; at least " + MIN_SIZE + " are needed");
    }
    for (int k = 1; k < size(); k++) {
      if (!(dtS(k) > 0)) {
        throw new IllegalArgumentException("times do not ascend at " + get(k).tS() + " s");
      }
    }
    boolean hasAcceleration = !Double.isNaN(get(0).aMS2());
    noise = new DMatrixRMaj(hasAcceleration ? 2 : 1, hasAcceleration ? 2 : 1);
    noise.set(0, 0, variance("x_m", Measurement::xM));
    if (hasAcceleration) {
      noise.set(1, 1, variance("a_m_s2", Measurement::aMS2));
    }
  }

  /**
   * Standard deviation of a displacement's noise: root mean square of the normalised third divided
   * differences, to which a constant acceleration adds nothing, and not less than q/√12 of the step
   * q in which displacements are given, such as a pixel. Gasser, Sroka and Jennen-Steinmetz (1986),
   * "Residual variance and residual pattern in nonlinear regression", with one difference more;
   * Widrow (1956) for q.
   *
   * @return metres, more than 0
   */
  public double noiseM() {
    return Math.sqrt(noise.get(0, 0));
  }

  int size() {
    return measurements.size();
  }

  Measurement get(int k) {
    return measurements.get(k);
  }

  /** Seconds since the previous measurement; 0 for the first. */
  double dtS(int k) {
    return k == 0 ? 0 : get(k).tS() - get(k - 1).tS();
  }

  /** The measurement at one time: x, or x and a. */
  double[] z(int k) {
    Measurement m = get(k);
    return noise.numRows == 1 ? new double[] {m.xM()} : new double[] {m.xM(), m.aMS2()};
  }

  /** A copy of R, the covariance of {@link #z}. */
  DMatrixRMaj noise() {
    return noise.copy();
  }

  /** Velocity by the central difference over three measurements; NaN at both ends. */
  double velocity(int k) {
    return isInside(k)
        ? (slope(k) * dtS(k + 1) + slope(k + 1) * dtS(k)) / (dtS(k) + dtS(k + 1))
        : Double.NaN;
  }

  /** Acceleration by the second difference over three measurements; NaN at both ends. */
  double acceleration(int k) {
    return isInside(k) ? 2 * (slope(k + 1) - slope(k)) / (dtS(k) + dtS(k + 1)) : Double.NaN;
  }

  private boolean isInside(int k) {
    return k > 0 && k < size() - 1;
  }

  private double slope(int k) {
    return (get(k).xM() - get(k - 1).xM()) / dtS(k);
  }

  private double variance(String name, ToDoubleFunction<Measurement> value) {
    double squares = 0;
    for (int k = 0; k + 3 < size(); k++) {
      double difference = 0;
      double weights = 0;
      for (int i = k; i <= k + 3; i++) {
        double weight = 1;
        for (int j = k; j <= k + 3; j++) {
          weight *= i == j ? 1 : dtS(k + 1) / (get(i).tS() - get(j).tS());
        }
        difference += weight * value.applyAsDouble(get(i));
        weights += weight * weight;
      }
      squares += difference * difference / weights;
    }
    double[] sorted = measurements.stream().mapToDouble(value).distinct().sorted().toArray();
    if (sorted.length == 1) {
      throw new IllegalArgumentException(name + " never changes; its noise cannot be estimated");
    }
    double variance = Math.max(squares / (size() - 3), Math.pow(step(sorted), 2) / 12);
    if (!(variance >= MIN_NOISE * MIN_NOISE && variance <= MAX_NOISE * MAX_NOISE)) {
      throw new IllegalArgumentException(
          name + " has a noise of " + Math.sqrt(variance) + "; check its unit");
    }
    return variance;
  }

  /** Greatest common divisor of all differences, by Euclid, to a billionth of the greatest. */
  private static double step(double... sorted) {
    double range = sorted[sorted.length - 1] - sorted[0];
    double step = range;
    for (int k = 1; k < sorted.length; k++) {
      double rest = sorted[k] - sorted[k - 1];
      while (rest > 1e-9 * range) {
        double remainder = Math.abs(Math.IEEEremainder(step, rest));
        step = rest;
        rest = remainder;
      }
    }
    return step;
  }
}
