package haltere.filters.orientation.internal.axis;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Initialises an axis from the lines of one time: a line and its camera span a plane that contains
 * the axis. The intersection of two planes with the most inliers is refined by least squares
 * (Gauss-Newton). Reused.
 */
public final class AxisLaunch {
  /** Sine of the angle of two planes below which they have no usable intersection. */
  private static final double MIN_CROSSING = Math.sin(Math.toRadians(4));

  private static final double MAX_INLIER_SQUARE = 4 * 4;

  /** Standard deviation of the axis in one direction above which it is unknown. */
  private static final double MAX_SD = Math.toRadians(25);

  /** Largest standard deviation of a line. */
  private static final double MAX_LINE_SD = Math.toRadians(6);

  private static final double MAX_STEP_RAD = 0.3;
  private static final int ROUNDS = 6;

  private final double outlierShare;
  private final double[] axis = new double[3];
  private final double[] first = new double[3];
  private final double[] second = new double[3];
  private final double[] cut = new double[3];
  private final double[] gradient = new double[3];
  private final double[] right = new double[3];
  private final DMatrixRMaj information = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj covariance = new DMatrixRMaj(3, 3);
  private boolean[] inlier = new boolean[16];
  private double determinant;
  private double odds;
  private int tried;

  /**
   * A search.
   *
   * @param outlierShare expected share of outliers among the lines
   */
  public AxisLaunch(double outlierShare) {
    this.outlierShare = outlierShare;
  }

  /** {@return the last axis, a unit vector; not a copy} */
  public double[] axis() {
    return axis;
  }

  /** Its covariance, nine entries; not a copy. */
  double[] covariance() {
    return covariance.data;
  }

  /** Number of lines of the search. */
  int lines() {
    return tried;
  }

  /** Reverses the axis. */
  public void reverse() {
    System.arraycopy(Vectors.scaled(-1, axis), 0, axis, 0, 3);
  }

  /**
   * Likelihood ratio of the lines with an axis, integrated over all axes (a Gaussian integral about
   * the one found), and of random lines.
   */
  double odds() {
    return odds;
  }

  /**
   * Searches an axis.
   *
   * @param lines the first ones are used
   * @param count their number
   * @return false with fewer than two lines, contradictory lines, or coincident planes
   */
  public boolean find(LineMeasurement[] lines, int count) {
    tried = count;
    double bestScore = 0;
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        lines[i].planeNormal(first);
        lines[j].planeNormal(second);
        if (!Vectors.normalise(first) || !Vectors.normalise(second)) {
          continue;
        }
        Vectors.cross(first, second, cut);
        if (!(Vectors.length(cut) > MIN_CROSSING)) {
          continue;
        }
        Vectors.normalise(cut);
        double score = 0; // count of inliers; among equal counts the smallest squares
        for (int k = 0; k < count; k++) {
          double square = square(lines[k], cut);
          score += square < MAX_INLIER_SQUARE ? 1 - square / MAX_INLIER_SQUARE / (count + 1) : 0;
        }
        if (score > bestScore) {
          bestScore = score;
          System.arraycopy(cut, 0, axis, 0, 3);
        }
      }
    }
    return bestScore > Math.min(3, Math.max(2, count)) - 1 && refine(lines, count);
  }

  private static double variance(LineMeasurement line) {
    return Math.min(line.varianceRad2, MAX_LINE_SD * MAX_LINE_SD);
  }

  /** Squared residual over its variance. */
  private static double square(LineMeasurement line, double[] direction) {
    double y = line.residual(direction);
    return y * y / variance(line);
  }

  private boolean refine(LineMeasurement[] lines, int count) {
    inlier = inlier.length < count ? new boolean[count] : inlier;
    for (int k = 0; k < count; k++) {
      inlier[k] = square(lines[k], axis) < MAX_INLIER_SQUARE;
    }
    for (int round = 0; round < ROUNDS; round++) {
      if (!step(lines, count)) {
        return false;
      }
    }
    weigh(lines, count);
    return Double.isFinite(axis[0] + axis[1] + axis[2] + CommonOps_DDRM.trace(covariance));
  }

  /**
   * A Gauss-Newton step. All gradients g are orthogonal to the axis u, so that G = Σ g gᵀ/r is
   * inverted as (G + c u uᵀ)⁻¹ = G⁺ + u uᵀ/c.
   */
  private boolean step(LineMeasurement[] lines, int count) {
    information.zero();
    Arrays.fill(right, 0);
    for (int k = 0; k < count; k++) {
      if (inlier[k] && lines[k].gradient(axis, gradient)) {
        double y = lines[k].residual(axis);
        double weight = 1 / variance(lines[k]);
        addSquare(information, weight, gradient);
        for (int i = 0; i < 3; i++) {
          right[i] += weight * y * gradient[i];
        }
      }
    }
    double c = CommonOps_DDRM.trace(information);
    addSquare(information, c, axis);
    determinant = CommonOps_DDRM.det(information) / c;
    // Half the trace of the inverse bounds the larger variance from below by half.
    if (!(determinant > 0) || !(c / determinant < 2 * MAX_SD * MAX_SD)) {
      return false;
    }
    CommonOps_DDRM.invert(information, covariance);
    addSquare(covariance, -1 / c, axis);
    Vectors.multiply(covariance.data, right, gradient);
    double limit = Math.min(1, MAX_STEP_RAD / Math.max(1e-12, Vectors.length(gradient)));
    for (int i = 0; i < 3; i++) {
      axis[i] += limit * gradient[i];
    }
    return Vectors.normalise(axis);
  }

  private static void addSquare(DMatrixRMaj m, double weight, double[] v) {
    for (int i = 0; i < 9; i++) {
      m.data[i] += weight * v[i / 3] * v[i % 3];
    }
  }

  private void weigh(LineMeasurement[] lines, int count) {
    double log = -0.5 * Math.log(determinant);
    for (int k = 0; k < count; k++) {
      double noise = 0.5 * Math.log(2 * Math.PI * variance(lines[k]));
      log +=
          inlier[k]
              ? Math.log((1 - outlierShare) * Math.PI) - 0.5 * square(lines[k], axis) - noise
              : Math.log(outlierShare);
    }
    odds = Math.exp(Math.max(-700, Math.min(700, log)));
  }
}
