package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;

/** Direction of the recent flight of a body: the sum of its steps with exponential memory. */
final class FlightDirection {
  private static final double MEMORY_S = 0.05;

  private final double[] wayM = new double[3];

  void forget() {
    Arrays.fill(wayM, 0);
  }

  /** A step from one position to another, metres. */
  void step(double[] from, double[] to, double dtS) {
    double left = Math.exp(-dtS / MEMORY_S);
    for (int k = 0; k < 3; k++) {
      wayM[k] = left * wayM[k] + to[k] - from[k];
    }
  }

  /** Gets the direction, three numbers; returns the displacement, metres. */
  double direction(double[] out) {
    System.arraycopy(wayM, 0, out, 0, 3);
    Vectors.normalise(out);
    return Vectors.length(wayM);
  }
}
