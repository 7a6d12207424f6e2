package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/**
 * Finds an axis from what cameras see at one time: each line spans a plane with its camera, and the
 * axis lies in all of them. Planes of each two cameras are cut, the cut that most lines agree with
 * is refined by least squares (Gauss and Newton). Reused.
 */
final class AxisLaunch {
  private static final double LEAST_CROSSING = Math.sin(Math.toRadians(4));
  private static final double INLIER_SIGMAS = 4;
  private static final double WORST_SD = Math.toRadians(25);
  private static final double GREATEST_SD = Math.toRadians(6);
  private static final int ROUNDS = 6;

  private final double outlierShare;
  private final double[] axis = new double[3];
  private final double[] covariance = new double[9];
  private final double[] best = new double[3];
  private final double[] first = new double[3];
  private final double[] second = new double[3];
  private final double[] cut = new double[3];
  private final double[] gradient = new double[3];
  private final double[] e2 = new double[3];
  private boolean[] inlier = new boolean[16];
  private double determinant;
  private double odds;
  private int tried;

  /**
   * A search.
   *
   * @param outlierShare share of lines that have nothing to do with the body
   */
  AxisLaunch(double outlierShare) {
    this.outlierShare = outlierShare;
  }

  /** What was found last: a unit vector; not a copy. */
  double[] axis() {
    return axis;
  }

  /** Its covariance, nine entries; not a copy. */
  double[] covariance() {
    return covariance;
  }

  /** How many lines it was found among. */
  int lines() {
    return tried;
  }

  /** Takes the opposite direction of the same line. */
  void turnRound() {
    for (int k = 0; k < 3; k++) {
      axis[k] = -axis[k];
    }
  }

  /**
   * How much likelier the lines are if this is their axis, found among all axes, than lines that
   * have nothing in common: by the integral over the sphere, which is that of a Gaussian.
   */
  double odds() {
    return odds;
  }

  /**
   * Searches.
   *
   * @param lines the first {@code count} of them
   * @param count how many
   * @return false where fewer than two lines tell, or they disagree, or all see the same plane
   */
  boolean find(LineMeasurement[] lines, int count) {
    tried = count;
    int bestInliers = 0;
    double bestCost = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      lines[i].planeNormal(first);
      if (!Vectors.normalise(first)) {
        continue;
      }
      for (int j = i + 1; j < count; j++) {
        lines[j].planeNormal(second);
        if (!Vectors.normalise(second)) {
          continue;
        }
        Vectors.cross(first, second, cut);
        if (!(Vectors.length(cut) > LEAST_CROSSING)) {
          continue;
        }
        Vectors.normalise(cut);
        int inliers = 0;
        double cost = 0;
        for (int k = 0; k < count; k++) {
          double y = lines[k].residual(cut);
          double square = y * y / variance(lines[k]);
          if (square < INLIER_SIGMAS * INLIER_SIGMAS) {
            inliers++;
            cost += square;
          }
        }
        if (inliers > bestInliers || (inliers == bestInliers && cost < bestCost)) {
          bestInliers = inliers;
          bestCost = cost;
          System.arraycopy(cut, 0, best, 0, 3);
        }
      }
    }
    return bestInliers >= Math.min(3, Math.max(2, count)) && refine(lines, count);
  }

  /**
   * A filter may be told that angles are worth nothing; what two lines have in common is worth
   * more.
   */
  private static double variance(LineMeasurement line) {
    return Math.min(line.varianceRad2, GREATEST_SD * GREATEST_SD);
  }

  private boolean refine(LineMeasurement[] lines, int count) {
    if (inlier.length < count) {
      inlier = new boolean[count];
    }
    for (int k = 0; k < count; k++) {
      double y = lines[k].residual(best);
      inlier[k] = y * y < INLIER_SIGMAS * INLIER_SIGMAS * variance(lines[k]);
    }
    System.arraycopy(best, 0, axis, 0, 3);
    for (int round = 0; round < ROUNDS; round++) {
      if (!step(lines, count)) {
        return false;
      }
    }
    weigh(lines, count);
    return Double.isFinite(axis[0] + axis[1] + axis[2] + covariance[0] + covariance[4]);
  }

  /** One step of Gauss and Newton. */
  private boolean step(LineMeasurement[] lines, int count) {
    double[] e1 = Vectors.orthogonalTo(axis);
    Vectors.cross(axis, e1, e2);
    double aa = 0;
    double ab = 0;
    double bb = 0;
    double a = 0;
    double b = 0;
    for (int k = 0; k < count; k++) {
      if (inlier[k] && lines[k].gradient(axis, gradient)) {
        double ha = Vectors.dot(gradient, e1);
        double hb = Vectors.dot(gradient, e2);
        double y = lines[k].residual(axis);
        double weight = 1 / variance(lines[k]);
        aa += weight * ha * ha;
        ab += weight * ha * hb;
        bb += weight * hb * hb;
        a += weight * ha * y;
        b += weight * hb * y;
      }
    }
    determinant = aa * bb - ab * ab;
    // Half the trace of the inverse bounds the larger variance from below by half.
    if (!(determinant > 0) || !((aa + bb) / determinant < 2 * WORST_SD * WORST_SD)) {
      return false;
    }
    double stepA = (bb * a - ab * b) / determinant;
    double stepB = (aa * b - ab * a) / determinant;
    double limit = Math.min(1, 0.3 / Math.max(1e-12, Math.hypot(stepA, stepB)));
    for (int i = 0; i < 3; i++) {
      axis[i] += limit * (stepA * e1[i] + stepB * e2[i]);
      for (int j = 0; j < 3; j++) {
        covariance[3 * i + j] =
            (bb * e1[i] * e1[j] + aa * e2[i] * e2[j] - ab * (e1[i] * e2[j] + e2[i] * e1[j]))
                / determinant;
      }
    }
    return Vectors.normalise(axis);
  }

  private void weigh(LineMeasurement[] lines, int count) {
    double log = -0.5 * Math.log(determinant);
    for (int k = 0; k < count; k++) {
      if (inlier[k]) {
        double y = lines[k].residual(axis);
        double r = variance(lines[k]);
        log +=
            Math.log((1 - outlierShare) * Math.PI) - 0.5 * (y * y / r + Math.log(2 * Math.PI * r));
      } else {
        log += Math.log(outlierShare);
      }
    }
    odds = Math.exp(Math.max(-700, Math.min(700, log)));
  }
}
