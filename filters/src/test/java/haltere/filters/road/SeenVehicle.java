package haltere.filters.road;

import haltere.core.event.SensorGeometry;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.RoadMapping;
import haltere.filters.plane.RoadViewSettings;
import haltere.filters.plane.VanishingPoint;
import java.util.SplittableRandom;

/**
 * A vehicle as a camera 5 m above a road sees it: its lower edge and its middle at given heights,
 * with errors in pixels that last for 0.3 s.
 *
 * @param lowM height of the lower edge
 * @param middleM height of the middle
 * @param behindM distance of the middle behind the nearer end
 */
record SeenVehicle(double xM, double yM, double vyMS, double lowM, double middleM, double behindM) {
  static final int ID = 4;
  static final double SD_PX = 0.75;
  static final double HEIGHT_M = 5;
  static final RoadMapping ROAD =
      new RoadMapping(
          new RoadViewSettings(HEIGHT_M, 6, 300, VanishingPoint.defaults()),
          new SensorGeometry(128, 128));
  private static final double SD_VELOCITY = 3;
  private static final double ERRORS_S = 0.3;

  /** Errors of the extent in the picture. */
  static final class Errors {
    private final SplittableRandom random;
    private final double size;
    private double low;
    private double row;
    private double column;

    Errors(long seed, double size) {
      random = new SplittableRandom(seed);
      this.size = size;
      low = size * gaussian();
      row = size * gaussian();
      column = size * gaussian();
    }

    double gaussian() {
      // Box and Muller (1958)
      return Math.sqrt(-2 * Math.log(1 - random.nextDouble()))
          * Math.cos(2 * Math.PI * random.nextDouble());
    }

    private double next(double error, double dt) {
      double keep = Math.exp(-dt / ERRORS_S);
      return keep * error + size * Math.sqrt(1 - keep * keep) * gaussian();
    }

    private void next(double dt) {
      low = next(low, dt);
      row = next(row, dt);
      column = next(column, dt);
    }
  }

  static ObjectTrack row(long timeUs, double x, double y, double low, double vx, double vy) {
    return new ObjectTrack(
        timeUs,
        ID,
        x,
        y,
        vx,
        vy,
        SD_PX,
        SD_PX,
        SD_VELOCITY,
        SD_VELOCITY,
        500,
        8,
        5,
        0,
        0.99,
        1e4,
        1.5,
        low);
  }

  double yAt(double s) {
    return yM + vyMS * s;
  }

  private static double scale(double heightM) {
    return HEIGHT_M / (HEIGHT_M - heightM);
  }

  private double middleRow(double afterS) {
    return ROAD.pixelY(0, scale(middleM) * (yAt(afterS) + behindM));
  }

  /** The row of its track now, a step later than the last. */
  ObjectTrack seen(long timeUs, double stepS, Errors errors) {
    errors.next(stepS);
    double scale = scale(middleM);
    double vy = (middleRow(1e-4) - middleRow(-1e-4)) / 2e-4;
    return row(
        timeUs,
        ROAD.pixelX(scale * xM, scale * (yM + behindM)) + errors.column,
        middleRow(0) + errors.row,
        ROAD.pixelY(0, scale(lowM) * yM) + errors.low,
        0,
        vy + errors.size * SD_VELOCITY * errors.gaussian());
  }

  /** The same vehicle elsewhere. */
  SeenVehicle at(double y, double vy) {
    return new SeenVehicle(xM, y, vy, lowM, middleM, behindM);
  }

  /** The row of its track after a time at a constant speed. */
  ObjectTrack seenAt(double s, double stepS, Errors errors) {
    return at(yAt(s), vyMS).seen(Math.round(s * 1e6), stepS, errors);
  }
}
