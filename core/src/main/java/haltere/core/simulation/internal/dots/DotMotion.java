package haltere.core.simulation.internal.dots;

import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The motion of one dot as a pure function of time.
 *
 * <p>Thread rule: immutable.
 */
final class DotMotion {
  private final DotPath path;
  private final double speed;
  private final double middleX;
  private final double middleY;
  private final double reach;
  private final double direction;
  private final double start;

  DotMotion(DotSettings dots, SensorSettings sensor, int index) {
    path = dots.path();
    speed = dots.speedPxS();
    middleX = (sensor.widthPx() - 1) / 2.0;
    double half = Math.min(sensor.widthPx(), sensor.heightPx()) / 2.0;
    double room = Math.max(1, half - dots.radiusPx() - 1);
    int count = dots.count();
    switch (path) {
      case CIRCLES -> {
        middleY = (sensor.heightPx() - 1) / 2.0;
        reach = room * (index + 1) / count;
        direction = index % 2 == 0 ? 1 : -1;
        start = 2.4 * index;
      }
      case LANES -> {
        middleY = sensor.heightPx() * (index + 1.0) / (count + 1) - 0.5;
        reach = Math.max(1, sensor.widthPx() / 2.0 - dots.radiusPx() - 1);
        direction = 0;
        start = 0.7 * index * reach;
      }
      default -> {
        middleY = (sensor.heightPx() - 1) / 2.0;
        reach = room;
        direction = Math.PI * index / count;
        start = reach;
      }
    }
  }

  private double angle(double seconds) {
    return start + direction * speed / reach * seconds;
  }

  /** Distance travelled to and fro along a line from its end at -reach, modulo 4 reach. */
  private double way(double seconds) {
    double turns = (start + speed * seconds) / (4 * reach);
    return (turns - Math.floor(turns)) * 4 * reach;
  }

  private double along(double seconds) {
    double way = way(seconds);
    return way < 2 * reach ? way - reach : 3 * reach - way;
  }

  private double pace(double seconds) {
    return way(seconds) < 2 * reach ? speed : -speed;
  }

  double x(double seconds) {
    return path == DotPath.CIRCLES
        ? middleX + reach * StrictMath.cos(angle(seconds))
        : middleX + along(seconds) * StrictMath.cos(direction);
  }

  double y(double seconds) {
    return path == DotPath.CIRCLES
        ? middleY + reach * StrictMath.sin(angle(seconds))
        : middleY + along(seconds) * StrictMath.sin(direction);
  }

  double velocityX(double seconds) {
    return path == DotPath.CIRCLES
        ? -direction * speed * StrictMath.sin(angle(seconds))
        : pace(seconds) * StrictMath.cos(direction);
  }

  double velocityY(double seconds) {
    return path == DotPath.CIRCLES
        ? direction * speed * StrictMath.cos(angle(seconds))
        : pace(seconds) * StrictMath.sin(direction);
  }
}
