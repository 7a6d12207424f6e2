package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/** Where a body has flown in the last moments: its steps, older ones counting less. */
final class Course {
  private static final double MEMORY_S = 0.05;

  private final double[] wayM = new double[3];

  void forget() {
    java.util.Arrays.fill(wayM, 0);
  }

  /** A step from one place to another, metres. */
  void step(double[] from, double[] to, double dtS) {
    double left = Math.exp(-dtS / MEMORY_S);
    for (int k = 0; k < 3; k++) {
      wayM[k] = left * wayM[k] + to[k] - from[k];
    }
  }

  /** Puts the direction into an array of three; false if there is none. */
  boolean direction(double[] out) {
    System.arraycopy(wayM, 0, out, 0, 3);
    return Vectors.normalise(out);
  }

  /** How far it has flown, metres. */
  double lengthM() {
    return Vectors.length(wayM);
  }
}
