package haltere.filters.wing.stroke;

/**
 * What events say in the first tenth of a second against the place that a person has given a hinge.
 */
final class UsualShift {
  private static final int LOOKS = 10;

  private double xx;
  private double xy;
  private double yy;
  private double rx;
  private double ry;
  private int looks;

  /** Begins anew. */
  void clear() {
    xx = 0;
    xy = 0;
    yy = 0;
    rx = 0;
    ry = 0;
    looks = 0;
  }

  /** Takes the normal equations of a shift, matrix and right side. */
  void add(double byXx, double byXy, double byYy, double byRx, double byRy) {
    xx += byXx;
    xy += byXy;
    yy += byYy;
    rx += byRx;
    ry += byRy;
    looks++;
  }

  /** Whether it is known. */
  boolean isLearnt() {
    return looks >= LOOKS;
  }

  /** The shift to the right, pixels; 0 where events say nothing. */
  double x() {
    double det = xx * yy - xy * xy;
    return det > 0 ? (yy * rx - xy * ry) / det : 0;
  }

  /** The shift upwards, pixels; 0 where events say nothing. */
  double y() {
    double det = xx * yy - xy * xy;
    return det > 0 ? (xx * ry - xy * rx) / det : 0;
  }
}
