package haltere.core.simulation.internal.flight;

import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SensorSettings;
import java.util.List;

/**
 * A camera of {@link FlightScene}, without lens distortion.
 *
 * @param id its name
 * @param matrix three rows of four numbers: from metres to pixels, x to the right, y up
 * @param widthPx columns
 * @param heightPx rows
 */
public record FlightCamera(String id, List<List<Double>> matrix, int widthPx, int heightPx) {
  /** Copies. */
  public FlightCamera {
    matrix = matrix.stream().map(List::copyOf).toList();
  }

  /** One of a ring of cameras that look at the origin. */
  static FlightCamera inRing(int index, FlightViewSettings view, SensorSettings sensor, long seed) {
    SeededRandom random = SeededRandom.of(seed, "camera", index);
    double around =
        Math.PI
            * (index + random.between(-0.15, 0.15))
            * (view.cameras() == 2 ? 0.5 : 2)
            / (view.cameras() == 2 ? 1 : view.cameras());
    double up = Math.toRadians(random.between(10, 55));
    double[] back = {
      StrictMath.cos(up) * StrictMath.cos(around),
      StrictMath.cos(up) * StrictMath.sin(around),
      StrictMath.sin(up)
    };
    double level = Math.hypot(back[0], back[1]);
    double[] right = {-back[1] / level, back[0] / level, 0};
    double[] top = {
      back[1] * right[2] - back[2] * right[1],
      back[2] * right[0] - back[0] * right[2],
      back[0] * right[1] - back[1] * right[0]
    };
    double focal =
        0.48
            * Math.min(sensor.widthPx(), sensor.heightPx())
            * (view.distanceM() - view.roomM())
            / view.roomM();
    double cx = (sensor.widthPx() - 1) / 2.0;
    double cy = (sensor.heightPx() - 1) / 2.0;
    double[][] rows = new double[3][4];
    for (int k = 0; k < 3; k++) {
      rows[0][k] = focal * right[k] - cx * back[k];
      rows[1][k] = focal * top[k] - cy * back[k];
      rows[2][k] = -back[k];
    }
    rows[0][3] = cx * view.distanceM();
    rows[1][3] = cy * view.distanceM();
    rows[2][3] = view.distanceM();
    List<List<Double>> matrix =
        java.util.Arrays.stream(rows)
            .map(row -> java.util.Arrays.stream(row).boxed().toList())
            .toList();
    return new FlightCamera("camera-" + index, matrix, sensor.widthPx(), sensor.heightPx());
  }

  private double row(int row, double[] point) {
    List<Double> m = matrix.get(row);
    return m.get(0) * point[0] + m.get(1) * point[1] + m.get(2) * point[2] + m.get(3);
  }

  /** Projects a point to pixels. */
  void project(double[] point, double[] pixel) {
    double depth = row(2, point);
    pixel[0] = row(0, point) / depth;
    pixel[1] = row(1, point) / depth;
  }

  /**
   * The outline of an ellipsoid of revolution: an ellipse, from the dual quadric C (S − A Aᵀ ...)
   * Cᵀ (Hartley and Zisserman 2004, section 8.3).
   *
   * @param position its centre, metres
   * @param axis unit vector
   * @param halfLength half its length, metres
   * @param halfWidth half its width, metres
   * @param ellipse gets the centre (x, y) and the matrix (xx, xy, yy) whose points p satisfy pᵀ
   *     matrix⁻¹ p = 1 about it
   */
  void outline(
      double[] position, double[] axis, double halfLength, double halfWidth, double[] ellipse) {
    double[] c = new double[9];
    double[][] shape = new double[4][4];
    double round = halfWidth * halfWidth;
    double longer = halfLength * halfLength - round;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        shape[i][j] = (i == j ? round : 0) + longer * axis[i] * axis[j] - position[i] * position[j];
      }
      shape[i][3] = -position[i];
      shape[3][i] = -position[i];
    }
    shape[3][3] = -1;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          for (int l = 0; l < 4; l++) {
            sum += matrix.get(i).get(k) * shape[k][l] * matrix.get(j).get(l);
          }
        }
        c[3 * i + j] = sum;
      }
    }
    double scale = -c[8];
    double x = -c[2] / scale;
    double y = -c[5] / scale;
    ellipse[0] = x;
    ellipse[1] = y;
    ellipse[2] = c[0] / scale + x * x;
    ellipse[3] = c[1] / scale + x * y;
    ellipse[4] = c[4] / scale + y * y;
  }
}
