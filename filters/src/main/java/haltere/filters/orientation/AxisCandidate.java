package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/** An axis that was found and waits to be found again, nearly the same and soon. */
final class AxisCandidate {
  private static final double SAME_AXIS = Math.cos(Math.toRadians(30));

  private final double longestS;
  private final double[] axis = new double[3];
  private double ageS = Double.POSITIVE_INFINITY;

  /** None yet; one older than so many seconds is none. */
  AxisCandidate(double longestS) {
    this.longestS = longestS;
  }

  void forget() {
    ageS = Double.POSITIVE_INFINITY;
  }

  /** Time has passed. */
  void age(double dtS) {
    ageS += dtS;
  }

  /** Whether an axis is the one that waits; from now on it is the one. */
  boolean isConfirmed(double[] found) {
    boolean confirmed = ageS <= longestS && Math.abs(Vectors.dot(found, axis)) > SAME_AXIS;
    System.arraycopy(found, 0, axis, 0, 3);
    ageS = 0;
    return confirmed;
  }
}
