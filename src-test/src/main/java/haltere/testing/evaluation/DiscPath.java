package haltere.testing.evaluation;

import java.util.SplittableRandom;

/**
 * The smooth way of a disc over the sensor: a line through a point, swinging to and fro across it.
 *
 * @param radius of the disc, pixels
 * @param meetingS when it is at the point, seconds
 * @param meetingX the point's column, pixels
 * @param meetingY the point's row, pixels
 * @param vx velocity along the line, pixels a second
 * @param vy velocity along the line, pixels a second
 * @param swing amplitude across the line, pixels
 * @param swingHz how often it swings a second
 */
record DiscPath(
    double radius,
    double meetingS,
    double meetingX,
    double meetingY,
    double vx,
    double vy,
    double swing,
    double swingHz) {

  /** A disc that passes a point at a speed of 40 to 300 px/s, half of them swinging. */
  static DiscPath through(
      SplittableRandom random, double meetingS, double x, double y, double angle, double speed) {
    boolean swings = random.nextBoolean();
    return new DiscPath(
        random.nextDouble(2.5, 7),
        meetingS,
        x,
        y,
        speed * Math.cos(angle),
        speed * Math.sin(angle),
        swings ? random.nextDouble(4, 15) : 0,
        random.nextDouble(0.3, 0.8));
  }

  private double phase(double seconds) {
    return 2 * Math.PI * swingHz * (seconds - meetingS);
  }

  private double across(double seconds) {
    return swing * Math.sin(phase(seconds));
  }

  private double acrossSpeed(double seconds) {
    return swing * 2 * Math.PI * swingHz * Math.cos(phase(seconds));
  }

  private double lineSpeed() {
    return Math.hypot(vx, vy);
  }

  double x(double seconds) {
    return meetingX + vx * (seconds - meetingS) - vy / lineSpeed() * across(seconds);
  }

  double y(double seconds) {
    return meetingY + vy * (seconds - meetingS) + vx / lineSpeed() * across(seconds);
  }

  double velocityX(double seconds) {
    return vx - vy / lineSpeed() * acrossSpeed(seconds);
  }

  double velocityY(double seconds) {
    return vy + vx / lineSpeed() * acrossSpeed(seconds);
  }

  double speed(double seconds) {
    return Math.hypot(velocityX(seconds), velocityY(seconds));
  }
}
