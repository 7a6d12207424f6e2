package haltere.testing.wings;

import java.util.Arrays;

/** Errors divided by their standard deviations, one after the other in time. */
final class NormalisedErrors {
  private double[] values = new double[1024];
  private int size;

  void add(double value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = value;
  }

  int size() {
    return size;
  }

  private double product(NormalisedErrors other, int count) {
    double sum = 0;
    for (int i = 0; i < count; i++) {
      sum += values[i] * other.values[i];
    }
    return sum;
  }

  /** Mean of the squares of all (NEES of one component). */
  static double meanSquare(NormalisedErrors... all) {
    double sum = 0;
    double count = 0;
    for (NormalisedErrors errors : all) {
      sum += errors.product(errors, errors.size);
      count += errors.size;
    }
    return sum / count;
  }

  /** Mean product of the errors of two scenes, tick by tick; where one is shorter, of its ticks. */
  static double meanProduct(NormalisedErrors[] one, NormalisedErrors[] other) {
    double sum = 0;
    double count = 0;
    for (int i = 0; i < one.length; i++) {
      int common = Math.min(one[i].size, other[i].size);
      sum += one[i].product(other[i], common);
      count += common;
    }
    return sum / count;
  }
}
