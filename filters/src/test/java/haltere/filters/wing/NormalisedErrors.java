package haltere.filters.wing;

import java.util.Arrays;

/**
 * Errors divided by their standard deviations, one after the other in time. Errors that follow each
 * other are alike, so that they count for fewer: N errors whose correlation over k steps is r_k
 * tell as much about their variance as N / (1 + 2 sum of r_k squared) independent ones (Bartlett
 * 1946).
 */
final class NormalisedErrors {
  private static final double NINETY_FIVE_PERCENT = 1.96;

  private double[] values = new double[1024];
  private int size;

  void add(double value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = value;
  }

  private double squares() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += values[i] * values[i];
    }
    return sum;
  }

  /** How many independent errors tell as much. */
  double independent() {
    double zero = squares();
    double sum = 0;
    for (int lag = 1; lag < size; lag++) {
      double product = 0;
      for (int i = 0; i + lag < size; i++) {
        product += values[i] * values[i + lag];
      }
      sum += product / zero * (product / zero);
    }
    return size / (1 + 2 * sum);
  }

  /** Mean of the squares of all. */
  static double meanSquare(NormalisedErrors... all) {
    double sum = 0;
    double count = 0;
    for (NormalisedErrors errors : all) {
      sum += errors.squares();
      count += errors.size;
    }
    return sum / count;
  }

  /** Whether the mean square is within the two-sided 95 % band of chi squared. */
  static boolean inBand(NormalisedErrors... all) {
    double freedom = 0;
    for (NormalisedErrors errors : all) {
      freedom += errors.independent();
    }
    double mean = meanSquare(all);
    return mean >= quantile(freedom, -NINETY_FIVE_PERCENT)
        && mean <= quantile(freedom, NINETY_FIVE_PERCENT);
  }

  /** Of chi squared over its degrees of freedom (Wilson and Hilferty 1931). */
  private static double quantile(double freedom, double sd) {
    double a = 2 / (9 * freedom);
    double root = Math.max(0, 1 - a + sd * Math.sqrt(a));
    return root * root * root;
  }
}
