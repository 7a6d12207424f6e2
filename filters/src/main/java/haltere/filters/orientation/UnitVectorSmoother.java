package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.List;

/**
 * The source's smoother: axes as if they were places, with constant velocity, Q = I and R = 30 I at
 * each step, P = 2 I at first; then made of length 1 again. For comparison.
 */
final class UnitVectorSmoother {
  private static final double Q = 1;
  private static final double R = 30;
  private static final double START = 2;

  private UnitVectorSmoother() {}

  /**
   * Smooths.
   *
   * @param axes unit vectors, those of neighbours on the same side
   * @param timesUs microseconds, ascending
   * @return as many unit vectors
   */
  static List<double[]> smooth(List<double[]> axes, List<Long> timesUs) {
    int count = axes.size();
    double[][] predictedP = new double[count][];
    double[][] updatedP = new double[count][];
    double[][] predictedX = new double[count][];
    double[][] updatedX = new double[count][];
    double[] p = {START, 0, START};
    double[] x = new double[6];
    for (int k = 0; k < count; k++) {
      if (k > 0) {
        double dtS = (timesUs.get(k) - timesUs.get(k - 1)) * 1e-6;
        for (int i = 0; i < 3; i++) {
          x[i] += dtS * x[3 + i];
        }
        p =
            new double[] {
              p[0] + 2 * dtS * p[1] + dtS * dtS * p[2] + Q, p[1] + dtS * p[2], p[2] + Q
            };
      } else {
        System.arraycopy(axes.get(0), 0, x, 0, 3);
      }
      predictedP[k] = p;
      predictedX[k] = x.clone();
      double s = p[0] + R;
      double placeGain = p[0] / s;
      double rateGain = p[1] / s;
      for (int i = 0; i < 3; i++) {
        double y = axes.get(k)[i] - predictedX[k][i];
        x[i] += placeGain * y;
        x[3 + i] += rateGain * y;
      }
      p = new double[] {p[0] * (1 - placeGain), p[1] * (1 - placeGain), p[2] - rateGain * p[1]};
      updatedP[k] = p;
      updatedX[k] = x.clone();
    }
    return back(timesUs, predictedP, updatedP, predictedX, updatedX);
  }

  private static List<double[]> back(
      List<Long> timesUs,
      double[][] predictedP,
      double[][] updatedP,
      double[][] predictedX,
      double[][] updatedX) {
    int count = timesUs.size();
    for (int k = count - 2; k >= 0; k--) {
      double dtS = (timesUs.get(k + 1) - timesUs.get(k)) * 1e-6;
      double[] p = updatedP[k];
      double[] next = predictedP[k + 1];
      double determinant = next[0] * next[2] - next[1] * next[1];
      double f00 = p[0] + dtS * p[1];
      double f10 = p[1] + dtS * p[2];
      double c00 = (f00 * next[2] - p[1] * next[1]) / determinant;
      double c01 = (p[1] * next[0] - f00 * next[1]) / determinant;
      double c10 = (f10 * next[2] - p[2] * next[1]) / determinant;
      double c11 = (p[2] * next[0] - f10 * next[1]) / determinant;
      for (int i = 0; i < 3; i++) {
        double place = updatedX[k + 1][i] - predictedX[k + 1][i];
        double rate = updatedX[k + 1][3 + i] - predictedX[k + 1][3 + i];
        updatedX[k][i] += c00 * place + c01 * rate;
        updatedX[k][3 + i] += c10 * place + c11 * rate;
      }
    }
    List<double[]> smoothed = new ArrayList<>(count);
    for (int k = 0; k < count; k++) {
      double[] u = {updatedX[k][0], updatedX[k][1], updatedX[k][2]};
      Vectors.normalise(u);
      smoothed.add(u);
    }
    return smoothed;
  }
}
