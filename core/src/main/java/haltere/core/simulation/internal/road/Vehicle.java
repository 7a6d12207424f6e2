package haltere.core.simulation.internal.road;

import java.util.List;

/**
 * The motion of a vehicle on the road as a function of time, in seconds since the beginning of the
 * scene.
 *
 * <p>Thread rule: immutable.
 */
final class Vehicle {
  private static final double CHECK_S = 0.1;
  private static final double ASIDE_M = 0.3;

  final int id;
  final VehicleKind kind;
  final boolean away;
  final double widthM;
  final double lengthM;
  final List<PaintedBox> parts;
  final double enterS;
  final double leaveS;
  private final Drive drive;
  private final Steering steering;
  private final double roadM;

  Vehicle(
      int id,
      Bodywork body,
      boolean away,
      double enterS,
      Drive drive,
      Steering steering,
      double roadM) {
    this(
        id,
        body.kind(),
        away,
        body.widthM(),
        body.lengthM(),
        body.parts(),
        enterS,
        drive,
        steering,
        roadM);
  }

  private Vehicle(
      int id,
      VehicleKind kind,
      boolean away,
      double widthM,
      double lengthM,
      List<PaintedBox> parts,
      double enterS,
      Drive drive,
      Steering steering,
      double roadM) {
    this.id = id;
    this.kind = kind;
    this.away = away;
    this.widthM = widthM;
    this.lengthM = lengthM;
    this.parts = parts;
    this.enterS = enterS;
    this.drive = drive;
    this.steering = steering;
    this.roadM = roadM;
    leaveS = enterS + drive.timeOf(roadM + lengthM);
  }

  /** The same vehicle, later by a time and with another number. */
  Vehicle later(double seconds, int number) {
    return new Vehicle(
        number, kind, away, widthM, lengthM, parts, enterS + seconds, drive, steering, roadM);
  }

  boolean isThere(double seconds) {
    return seconds >= enterS && seconds < leaveS;
  }

  /** Its middle, metres to the right. */
  double x(double seconds) {
    return steering.position(seconds - enterS);
  }

  /** The end that is nearer to the camera, metres ahead. */
  double near(double seconds) {
    double distance = drive.distanceM(seconds - enterS);
    return away ? distance - lengthM : roadM - distance;
  }

  double speedX(double seconds) {
    return steering.speed(seconds - enterS);
  }

  double speedY(double seconds) {
    double speed = drive.speed(seconds - enterS);
    return away ? speed : -speed;
  }

  /** Whether two vehicles keep their distance while both are there. */
  boolean avoids(Vehicle other) {
    double untilS = Math.min(leaveS, other.leaveS);
    for (double s = Math.max(enterS, other.enterS); s <= untilS; s += CHECK_S) {
      double aside = Math.abs(x(s) - other.x(s));
      if (aside < (widthM + other.widthM) / 2 + ASIDE_M) {
        double apart = Math.abs(near(s) + lengthM / 2 - other.near(s) - other.lengthM / 2);
        double slower = Math.min(Math.abs(speedY(s)), Math.abs(other.speedY(s)));
        if (apart < (lengthM + other.lengthM) / 2 + distance(slower)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Distance that vehicles keep to the one before them, metres. */
  static double distance(double speed) {
    return 2 + 0.3 * speed;
  }
}
