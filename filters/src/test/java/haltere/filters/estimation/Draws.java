package haltere.filters.estimation;

import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;

/**
 * Seeded random vectors of given covariance, for simulated truths and measurements. Of a generator
 * whose streams of neighbouring seeds are independent; those of {@code java.util.Random} are not.
 */
final class Draws {
  private final SplittableRandom random;

  Draws(long seed) {
    random = new SplittableRandom(seed);
  }

  double normal(double standardDeviation) {
    return standardDeviation * random.nextGaussian();
  }

  double uniform(double from, double to) {
    return from + (to - from) * random.nextDouble();
  }

  /** A vector of mean 0; the covariance may be singular. */
  DMatrixRMaj normal(DMatrixRMaj covariance) {
    int n = covariance.numRows;
    DMatrixRMaj u = new DMatrixRMaj(n, n);
    double[] d = new double[n];
    UdFactors.of(covariance, u, d);
    DMatrixRMaj x = new DMatrixRMaj(n, 1);
    for (int j = 0; j < n; j++) {
      double draw = normal(Math.sqrt(d[j]));
      for (int i = 0; i <= j; i++) {
        x.add(i, 0, u.get(i, j) * draw);
      }
    }
    return x;
  }

  /** A covariance with correlations, each standard deviation within a factor of three of 1. */
  DMatrixRMaj covariance(int n) {
    DMatrixRMaj p = new DMatrixRMaj(n, n);
    double[][] a = new double[n][n];
    for (double[] row : a) {
      for (int j = 0; j < n; j++) {
        row[j] = random.nextGaussian();
      }
    }
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        double sum = i == j ? 0.1 : 0;
        for (int k = 0; k < n; k++) {
          sum += a[i][k] * a[j][k] / n;
        }
        p.set(i, j, sum);
      }
    }
    return p;
  }
}
