package haltere.ui.space;

/**
 * The box around points in space.
 *
 * @param least smallest coordinates x, y and z, metres
 * @param most largest coordinates, metres
 */
record SpaceBounds(double[] least, double[] most) {
  /** The box around points; of no size, at the origin, where there are none. */
  static SpaceBounds of(Iterable<double[]> points) {
    double[] least = null;
    double[] most = null;
    for (double[] point : points) {
      least = least == null ? point.clone() : least;
      most = most == null ? point.clone() : most;
      for (int k = 0; k < 3; k++) {
        least[k] = Math.min(least[k], point[k]);
        most[k] = Math.max(most[k], point[k]);
      }
    }
    return least == null
        ? new SpaceBounds(new double[3], new double[3])
        : new SpaceBounds(least, most);
  }

  double middle(int coordinate) {
    return 0.5 * (least[coordinate] + most[coordinate]);
  }

  /** Length from corner to corner, metres, more than 0. */
  double diagonalM() {
    double level = Math.hypot(most[0] - least[0], most[1] - least[1]);
    return Math.max(1e-6, Math.hypot(level, most[2] - least[2]));
  }
}
