package haltere.core.simulation.internal.fly;

/**
 * The pose of the fly and its wings at one instant; a buffer that {@link FlyKinematics} fills.
 * Index 0 is the left wing, 1 the right.
 */
final class FlyPose {
  double centreX;
  double centreY;
  double heading;
  double cosHeading;
  double sinHeading;
  final double[] hingeX = new double[2];
  final double[] hingeY = new double[2];

  /** Phase in cycles since the beginning of the scene, not wrapped. */
  final double[] cycles = new double[2];

  final double[] frequencyHz = new double[2];
  final double[] amplitude = new double[2];
  final double[] centre = new double[2];
}
