package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/**
 * Position and orientation of a body at one time.
 *
 * @param timeUs time, microseconds
 * @param xM position, metres
 * @param yM position, metres
 * @param zM position, metres
 * @param ux axis, a unit vector from tail to head
 * @param uy axis
 * @param uz axis
 * @param sdAxisRad root mean square of the angle between this axis and the true one, at most that
 *     of a random direction (1.71)
 * @param sdRollRad standard deviation of roll, which is not observable: that of a uniform angle
 *     (1.81) or more
 * @param pRadS roll rate; not observable, so 0 unless the filter has a state for it
 * @param qRadS pitch rate of a body whose back is up, positive nose down
 * @param rRadS yaw rate of a body whose back is up, positive to the left
 * @param headProbability probability that this end is the head, 0 to 1
 * @param used number of observations of this time used for the axis
 * @param rejected number of other observations of this time
 */
public record OrientationEstimate(
    long timeUs,
    double xM,
    double yM,
    double zM,
    double ux,
    double uy,
    double uz,
    double sdAxisRad,
    double sdRollRad,
    double pRadS,
    double qRadS,
    double rRadS,
    double headProbability,
    int used,
    int rejected) {
  /** Root of the mean squared angle between a direction and a random one. */
  private static final double RANDOM_SD = Math.sqrt((Math.PI * Math.PI - 4) / 2);

  /**
   * The line through the position along the axis, in Plücker coordinates as Hartley and Zisserman
   * (2004, section 3.2.2) order them and Flydra stores them in {@code hz_line0} to {@code
   * hz_line5}: the entries 12, 13, 14, 23, 42, 34 of A Bᵀ − B Aᵀ, with the homogeneous points A =
   * (position, 1) and B = (position + axis, 1).
   *
   * @return six numbers: three of the moment m = position × axis in metres, three of the axis u, as
   *     (m_z, −m_y, −u_x, m_x, u_y, −u_z)
   */
  public double[] hzLine() {
    double[] moment = new double[3];
    Vectors.cross(new double[] {xM, yM, zM}, new double[] {ux, uy, uz}, moment);
    return new double[] {moment[2], -moment[1], -ux, moment[0], uy, -uz};
  }

  /**
   * An estimate of vectors: the axis, a unit vector from tail to head, and the velocity of the head
   * on the unit sphere, per second.
   */
  static OrientationEstimate of(
      long timeUs,
      double[] positionM,
      double[] axis,
      double[] tip,
      double sdAxisRad,
      double sdRollRad,
      double pRadS,
      double headProbability,
      int used,
      int rejected) {
    double[] rates = rates(axis, tip);
    return new OrientationEstimate(
        timeUs,
        positionM[0],
        positionM[1],
        positionM[2],
        axis[0],
        axis[1],
        axis[2],
        Math.min(RANDOM_SD, sdAxisRad),
        sdRollRad,
        pRadS,
        rates[0],
        rates[1],
        headProbability,
        used,
        rejected);
  }

  /** Rates q and r of a tip velocity in the frame of a body whose back is up. */
  private static double[] rates(double[] axis, double[] tipVelocity) {
    double[] turning = new double[3];
    Vectors.cross(axis, tipVelocity, turning);
    double[] left = {-axis[1], axis[0], 0};
    if (!(Math.hypot(left[0], left[1]) > 1e-9)) {
      left[0] = 0;
      left[1] = 1;
    }
    Vectors.normalise(left);
    double[] back = new double[3];
    Vectors.cross(axis, left, back);
    return new double[] {Vectors.dot(turning, left), Vectors.dot(turning, back)};
  }
}
