package haltere.testing.objects;

import java.util.SplittableRandom;

/**
 * Motion of a simulated object along a wavy line through a point, or an ellipse around it, with or
 * without a stop of {@value #STOP_S} s.
 *
 * @param orbit whether it is an ellipse
 * @param x the point's column, pixels
 * @param y the point's row, pixels
 * @param ax velocity along the line, pixels a second; first half axis of the ellipse, pixels
 * @param ay the same in y
 * @param bx amplitude of the waves across the line, or second half axis, pixels
 * @param by the same in y
 * @param rateRadS angular rate of the waves or on the ellipse, radians a second
 * @param phaseRad phase at the start, radians
 * @param meetingS when it is at the point of the line but for the waves, seconds
 * @param stopS when it begins to brake, seconds; NaN if it never stops
 */
record Motion(
    boolean orbit,
    double x,
    double y,
    double ax,
    double ay,
    double bx,
    double by,
    double rateRadS,
    double phaseRad,
    double meetingS,
    double stopS) {
  /** Duration of a stop, seconds. */
  static final double STOP_S = 2;

  /** Duration of braking and of starting, seconds. */
  private static final double RAMP_S = 0.3;

  /** A straight or wavy line. */
  static Motion line(
      SplittableRandom random, double x, double y, double angleRad, double speed, double meetingS) {
    double vx = speed * Math.cos(angleRad);
    double vy = speed * Math.sin(angleRad);
    double rate = random.nextDouble(0.5, 2);
    // Waves turn the direction by at most 17 degrees.
    double wave = random.nextBoolean() ? 0 : random.nextDouble(0, 0.3) / rate;
    double phase = random.nextDouble(2 * Math.PI);
    return new Motion(
        false, x, y, vx, vy, -vy * wave, vx * wave, rate, phase, meetingS, Double.NaN);
  }

  /** An ellipse at a mean speed. */
  static Motion orbit(
      SplittableRandom random,
      double x,
      double y,
      double halfWidth,
      double halfHeight,
      double speed) {
    double rate = speed / ((halfWidth + halfHeight) / 2) * (random.nextBoolean() ? 1 : -1);
    double phase = random.nextDouble(2 * Math.PI);
    return new Motion(true, x, y, halfWidth, 0, 0, halfHeight, rate, phase, 0, Double.NaN);
  }

  /** The same path with a stop. */
  Motion stopping(double atS) {
    return new Motion(orbit, x, y, ax, ay, bx, by, rateRadS, phaseRad, meetingS, atS);
  }

  /** The same line at another place and speed. */
  Motion beside(double dx, double dy, double factor) {
    return new Motion(
        orbit,
        x + dx,
        y + dy,
        ax * factor,
        ay * factor,
        bx,
        by,
        rateRadS,
        phaseRad,
        meetingS,
        stopS);
  }

  /** Share of the full speed at a time, 0 to 1. */
  double pace(double s) {
    double since = s - stopS;
    double until = since - RAMP_S - STOP_S;
    if (Double.isNaN(stopS) || since <= 0 || until >= RAMP_S) {
      return 1;
    }
    return Math.max(0, Math.max(1 - since / RAMP_S, until / RAMP_S));
  }

  /** Time along the path without stops, seconds. */
  double progressS(double s) {
    double since = s - stopS;
    if (Double.isNaN(stopS) || since <= 0) {
      return s;
    }
    double braked = Math.min(since, RAMP_S);
    double started = Math.min(Math.max(0, since - RAMP_S - STOP_S), RAMP_S);
    double after = Math.max(0, since - 2 * RAMP_S - STOP_S);
    return stopS
        + braked
        - braked * braked / (2 * RAMP_S)
        + started * started / (2 * RAMP_S)
        + after;
  }

  private double turn(double s) {
    return rateRadS * progressS(s) + phaseRad;
  }

  double x(double s) {
    return x + along(ax, bx, s);
  }

  double y(double s) {
    return y + along(ay, by, s);
  }

  private double along(double a, double b, double s) {
    double first = orbit ? Math.cos(turn(s)) : progressS(s) - meetingS;
    return a * first + b * Math.sin(turn(s));
  }

  double vx(double s) {
    return pace(s) * slope(ax, bx, s);
  }

  double vy(double s) {
    return pace(s) * slope(ay, by, s);
  }

  private double slope(double a, double b, double s) {
    double first = orbit ? -rateRadS * Math.sin(turn(s)) : 1;
    return a * first + b * rateRadS * Math.cos(turn(s));
  }

  /** Direction of the path, radians, also during a stop. */
  double headingRad(double s) {
    return Math.atan2(slope(ay, by, s), slope(ax, bx, s));
  }

  /** Upper bound of the speed, pixels a second. */
  double maxSpeed() {
    double b = Math.hypot(bx, by) * Math.abs(rateRadS);
    return orbit ? Math.max(b, Math.hypot(ax, ay) * Math.abs(rateRadS)) : Math.hypot(ax, ay) + b;
  }
}
