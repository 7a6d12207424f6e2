package haltere.core.simulation.internal.road;

import java.util.Arrays;

/**
 * The distance that a vehicle has driven as a function of time: intervals of constant acceleration,
 * the last one unlimited and without acceleration.
 *
 * <p>Thread rule: immutable.
 */
final class Drive {
  private final double[] atS;
  private final double[] distanceM;
  private final double[] speedMS;
  private final double[] acceleration;

  private Drive(double[] atS, double[] distanceM, double[] speedMS, double[] acceleration) {
    this.atS = atS;
    this.distanceM = distanceM;
    this.speedMS = speedMS;
    this.acceleration = acceleration;
  }

  /** A drive at one speed. */
  static Drive steady(double speed) {
    return new Drive(new double[] {0}, new double[] {0}, new double[] {speed}, new double[] {0});
  }

  /** This drive with an acceleration in an interval after its last change. */
  Drive then(double fromS, double toS, double change) {
    int last = atS.length - 1;
    double distance = distanceM[last] + speedMS[last] * (fromS - atS[last]);
    double duration = toS - fromS;
    double speed = speedMS[last] + change * duration;
    if (Math.abs(speed) < 1e-9) {
      speed = 0;
    }
    double after = distance + (speedMS[last] + speed) / 2 * duration;
    return new Drive(
        append(atS, fromS, toS),
        append(distanceM, distance, after),
        append(speedMS, speedMS[last], speed),
        append(acceleration, change, 0));
  }

  private static double[] append(double[] values, double a, double b) {
    double[] longer = Arrays.copyOf(values, values.length + 2);
    longer[values.length] = a;
    longer[values.length + 1] = b;
    return longer;
  }

  private int stretch(double seconds) {
    int i = atS.length - 1;
    while (i > 0 && seconds < atS[i]) {
      i--;
    }
    return i;
  }

  /** Distance since time 0, metres; negative before it. */
  double distanceM(double seconds) {
    int i = stretch(seconds);
    double t = seconds - atS[i];
    return distanceM[i] + t * (speedMS[i] + acceleration[i] * t / 2);
  }

  /** Speed, metres per second. */
  double speed(double seconds) {
    int i = stretch(seconds);
    return speedMS[i] + acceleration[i] * (seconds - atS[i]);
  }

  /** The time at which a distance greater than 0 has been driven. */
  double timeOf(double distance) {
    int i = 0;
    while (i < atS.length - 1 && distance >= distanceM[i + 1]) {
      i++;
    }
    double rest = distance - distanceM[i];
    if (acceleration[i] == 0) {
      return atS[i] + rest / speedMS[i];
    }
    double speed = Math.sqrt(speedMS[i] * speedMS[i] + 2 * acceleration[i] * rest);
    return atS[i] + (speed - speedMS[i]) / acceleration[i];
  }
}
