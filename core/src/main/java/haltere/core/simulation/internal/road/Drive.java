package haltere.core.simulation.internal.road;

import java.util.Arrays;

/**
 * The way of a vehicle along the road as a function of time: stretches of constant acceleration,
 * the last one without end and without acceleration.
 *
 * <p>Thread rule: immutable.
 */
final class Drive {
  private final double[] atS;
  private final double[] wayM;
  private final double[] speedMS;
  private final double[] acceleration;

  private Drive(double[] atS, double[] wayM, double[] speedMS, double[] acceleration) {
    this.atS = atS;
    this.wayM = wayM;
    this.speedMS = speedMS;
    this.acceleration = acceleration;
  }

  /** A drive at one speed. */
  static Drive steady(double speed) {
    return new Drive(new double[] {0}, new double[] {0}, new double[] {speed}, new double[] {0});
  }

  /** This drive, but that it has the acceleration from a time to a time after its last stretch. */
  Drive then(double fromS, double toS, double change) {
    int last = atS.length - 1;
    double way = wayM[last] + speedMS[last] * (fromS - atS[last]);
    double duration = toS - fromS;
    double speed = speedMS[last] + change * duration;
    if (Math.abs(speed) < 1e-9) {
      speed = 0;
    }
    double after = way + (speedMS[last] + speed) / 2 * duration;
    return new Drive(
        append(atS, fromS, toS),
        append(wayM, way, after),
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

  /** Metres since time 0; negative before it. */
  double way(double seconds) {
    int i = stretch(seconds);
    double t = seconds - atS[i];
    return wayM[i] + t * (speedMS[i] + acceleration[i] * t / 2);
  }

  /** Metres a second. */
  double speed(double seconds) {
    int i = stretch(seconds);
    return speedMS[i] + acceleration[i] * (seconds - atS[i]);
  }

  /** The time at which a way has been made that is greater than 0. */
  double timeOf(double way) {
    int i = 0;
    while (i < atS.length - 1 && way >= wayM[i + 1]) {
      i++;
    }
    double rest = way - wayM[i];
    if (acceleration[i] == 0) {
      return atS[i] + rest / speedMS[i];
    }
    double speed = Math.sqrt(speedMS[i] * speedMS[i] + 2 * acceleration[i] * rest);
    return atS[i] + (speed - speedMS[i]) / acceleration[i];
  }
}
