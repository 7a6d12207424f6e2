package haltere.ui.space;

/**
 * The box around points in space.
 *
 * @param min smallest coordinates x, y and z, metres
 * @param max largest coordinates, metres
 */
record SpaceBounds(double[] min, double[] max) {
  /** The box around points; a point at the origin without points. */
  static SpaceBounds of(Iterable<double[]> points) {
    double[] min = null;
    double[] max = null;
    for (double[] point : points) {
      min = min == null ? point.clone() : min;
      max = max == null ? point.clone() : max;
      for (int k = 0; k < 3; k++) {
        min[k] = Math.min(min[k], point[k]);
        max[k] = Math.max(max[k], point[k]);
      }
    }
    return min == null ? new SpaceBounds(new double[3], new double[3]) : new SpaceBounds(min, max);
  }

  double middle(int coordinate) {
    return 0.5 * (min[coordinate] + max[coordinate]);
  }

  /** Length from corner to corner, metres, more than 0. */
  double diagonalM() {
    double level = Math.hypot(max[0] - min[0], max[1] - min[1]);
    return Math.max(1e-6, Math.hypot(level, max[2] - min[2]));
  }
}
