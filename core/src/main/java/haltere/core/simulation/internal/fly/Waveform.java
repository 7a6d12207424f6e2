package haltere.core.simulation.internal.fly;

/**
 * A periodic function of phase without a constant term: the sum over k of c<sub>k</sub> cos(k
 * phase) + s<sub>k</sub> sin(k phase).
 *
 * <p>Thread rule: immutable.
 */
final class Waveform {
  private static final int SEARCH = 3600;

  private final double[] cosines;
  private final double[] sines;
  private final double phaseOfMax;
  private final double phaseOfMin;

  private Waveform(double[] cosines, double[] sines) {
    this.cosines = cosines.clone();
    this.sines = sines.clone();
    int highest = 0;
    int lowest = 0;
    for (int i = 1; i < SEARCH; i++) {
      highest = at(grid(i)) > at(grid(highest)) ? i : highest;
      lowest = at(grid(i)) < at(grid(lowest)) ? i : lowest;
    }
    phaseOfMax = zeroOfSlope(grid(highest - 1), grid(highest + 1));
    phaseOfMin = zeroOfSlope(grid(lowest - 1), grid(lowest + 1));
  }

  /** Terms of the first, second, ... harmonic. */
  static Waveform ofTerms(double[] cosines, double[] sines) {
    return new Waveform(cosines, sines);
  }

  private static double grid(int i) {
    return 2 * Math.PI * i / SEARCH;
  }

  /** The same shape with half of peak to peak 1 and its rising zero crossing at phase 0. */
  Waveform normalised() {
    double scale = 2 / (max() - min());
    double shift = risingZero();
    double[] shiftedCosines = new double[cosines.length];
    double[] shiftedSines = new double[sines.length];
    for (int k = 0; k < cosines.length; k++) {
      double c = StrictMath.cos((k + 1) * shift);
      double s = StrictMath.sin((k + 1) * shift);
      shiftedCosines[k] = scale * (cosines[k] * c + sines[k] * s);
      shiftedSines[k] = scale * (sines[k] * c - cosines[k] * s);
    }
    return new Waveform(shiftedCosines, shiftedSines);
  }

  /** Value at a phase in radians. */
  double at(double phase) {
    double c1 = StrictMath.cos(phase);
    double s1 = StrictMath.sin(phase);
    double c = c1;
    double s = s1;
    double sum = cosines[0] * c + sines[0] * s;
    for (int k = 1; k < cosines.length; k++) {
      double next = c * c1 - s * s1;
      s = s * c1 + c * s1;
      c = next;
      sum += cosines[k] * c + sines[k] * s;
    }
    return sum;
  }

  /** Derivative with respect to phase. */
  double slopeAt(double phase) {
    double sum = 0;
    for (int k = 1; k <= cosines.length; k++) {
      sum +=
          k
              * (sines[k - 1] * StrictMath.cos(k * phase)
                  - cosines[k - 1] * StrictMath.sin(k * phase));
    }
    return sum;
  }

  /** Largest value. */
  double max() {
    return at(phaseOfMax);
  }

  /** Smallest value. */
  double min() {
    return at(phaseOfMin);
  }

  /** Phase of the largest value, where a wing turns back to the head. */
  double phaseOfMax() {
    return phaseOfMax;
  }

  /** Phase of the smallest value, where a wing turns back to the tail. */
  double phaseOfMin() {
    return phaseOfMin;
  }

  /** Share of the cycle from the largest to the smallest value. */
  double shareFromMaxToMin() {
    double share = (phaseOfMin - phaseOfMax) / (2 * Math.PI);
    return share - Math.floor(share);
  }

  private double zeroOfSlope(double from, double to) {
    double low = from;
    double high = to;
    boolean falling = slopeAt(low) > 0;
    for (int i = 0; i < 60; i++) {
      double middle = (low + high) / 2;
      if ((slopeAt(middle) > 0) == falling) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return (low + high) / 2;
  }

  private double risingZero() {
    double low = phaseOfMin;
    double high = phaseOfMax > phaseOfMin ? phaseOfMax : phaseOfMax + 2 * Math.PI;
    for (int i = 0; i < 60; i++) {
      double middle = (low + high) / 2;
      if (at(middle) < 0) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return (low + high) / 2;
  }
}
