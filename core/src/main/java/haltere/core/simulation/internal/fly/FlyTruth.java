package haltere.core.simulation.internal.fly;

/**
 * The truth about the fly at one time. Pixels and angles are those of the whole program: x to the
 * right, y up, the origin at the centre of the bottom left pixel; heading counterclockwise from +x;
 * stroke angles at the hinge from the heading, positive on both sides, 0 at the head, pi at the
 * tail, in [0, 2 pi).
 *
 * <p>The centre of a stroke is its mean angle over the cycle (not the middle of its extremes, which
 * a second harmonic moves away from it), the amplitude half of peak to peak, phase 0 the passage
 * through the centre towards the tail, in [0, 2 pi), and advances with the frequency. The leading
 * edge is the one in front in the direction of motion; the two change sides at each reversal.
 *
 * @param tUs time on the clock of the events, microseconds
 * @param leftAngleRad stroke angle of the left wing's middle line
 * @param leftLeadingRad stroke angle of its leading edge, which makes OFF events
 * @param leftTrailingRad stroke angle of its trailing edge, which makes ON events
 * @param leftCentreRad mean stroke angle of the left wing
 * @param leftAmplitudeRad half of peak to peak of the left wing
 * @param leftPhaseRad phase of the left wing
 * @param leftFrequencyHz beat frequency of the left wing, hertz
 * @param rightAngleRad stroke angle of the right wing's middle line
 * @param rightLeadingRad stroke angle of its leading edge, which makes OFF events
 * @param rightTrailingRad stroke angle of its trailing edge, which makes ON events
 * @param rightCentreRad mean stroke angle of the right wing
 * @param rightAmplitudeRad half of peak to peak of the right wing
 * @param rightPhaseRad phase of the right wing
 * @param rightFrequencyHz beat frequency of the right wing, hertz
 * @param centreXPx body centre, the middle between the hinges, pixels
 * @param centreYPx body centre, pixels
 * @param headingRad direction from tail to head, in [0, 2 pi)
 * @param leftHingeXPx hinge of the left wing, pixels
 * @param leftHingeYPx hinge of the left wing, pixels
 * @param rightHingeXPx hinge of the right wing, pixels
 * @param rightHingeYPx hinge of the right wing, pixels
 */
public record FlyTruth(
    long tUs,
    double leftAngleRad,
    double leftLeadingRad,
    double leftTrailingRad,
    double leftCentreRad,
    double leftAmplitudeRad,
    double leftPhaseRad,
    double leftFrequencyHz,
    double rightAngleRad,
    double rightLeadingRad,
    double rightTrailingRad,
    double rightCentreRad,
    double rightAmplitudeRad,
    double rightPhaseRad,
    double rightFrequencyHz,
    double centreXPx,
    double centreYPx,
    double headingRad,
    double leftHingeXPx,
    double leftHingeYPx,
    double rightHingeXPx,
    double rightHingeYPx) {

  /**
   * The left wing alone.
   *
   * @return its part of the row
   */
  public Wing left() {
    return new Wing(
        leftAngleRad,
        leftLeadingRad,
        leftTrailingRad,
        leftCentreRad,
        leftAmplitudeRad,
        leftPhaseRad,
        leftFrequencyHz);
  }

  /**
   * The right wing alone.
   *
   * @return its part of the row
   */
  public Wing right() {
    return new Wing(
        rightAngleRad,
        rightLeadingRad,
        rightTrailingRad,
        rightCentreRad,
        rightAmplitudeRad,
        rightPhaseRad,
        rightFrequencyHz);
  }

  /**
   * The truth about one wing.
   *
   * @param angleRad stroke angle of its middle line
   * @param leadingRad stroke angle of its leading edge
   * @param trailingRad stroke angle of its trailing edge
   * @param centreRad mean stroke angle
   * @param amplitudeRad half of peak to peak
   * @param phaseRad phase, 0 where it passes its centre towards the tail
   * @param frequencyHz beat frequency, hertz
   */
  public record Wing(
      double angleRad,
      double leadingRad,
      double trailingRad,
      double centreRad,
      double amplitudeRad,
      double phaseRad,
      double frequencyHz) {
    /** A dark sector about its hinge. */
    static Wing of(FlyPose pose, int side, Waveform waveform, double widthRad) {
      double cycles = pose.cycles[side];
      double phase = wrapped(2 * Math.PI * (cycles - Math.floor(cycles)));
      double angle = pose.centre[side] + pose.amplitude[side] * waveform.at(phase);
      double ahead = waveform.slopeAt(phase) >= 0 ? widthRad / 2 : -widthRad / 2;
      return new Wing(
          wrapped(angle),
          wrapped(angle + ahead),
          wrapped(angle - ahead),
          pose.centre[side],
          pose.amplitude[side],
          phase,
          pose.frequencyHz[side]);
    }
  }

  /** The truth of a pose. */
  static FlyTruth of(long tUs, FlyPose pose, Wing left, Wing right) {
    return new FlyTruth(
        tUs,
        left.angleRad,
        left.leadingRad,
        left.trailingRad,
        left.centreRad,
        left.amplitudeRad,
        left.phaseRad,
        left.frequencyHz,
        right.angleRad,
        right.leadingRad,
        right.trailingRad,
        right.centreRad,
        right.amplitudeRad,
        right.phaseRad,
        right.frequencyHz,
        pose.centreX,
        pose.centreY,
        wrapped(pose.heading),
        pose.hingeX[FlyKinematics.LEFT],
        pose.hingeY[FlyKinematics.LEFT],
        pose.hingeX[FlyKinematics.RIGHT],
        pose.hingeY[FlyKinematics.RIGHT]);
  }

  /** An angle in [0, 2 pi). */
  static double wrapped(double angle) {
    double turns = angle / (2 * Math.PI);
    double wrapped = angle - 2 * Math.PI * Math.floor(turns);
    return wrapped >= 2 * Math.PI || wrapped < 0 ? 0 : wrapped;
  }
}
