package haltere.ui.rendering;

import haltere.core.event.SensorGeometry;

/**
 * Parallel projection of sensor columns, sensor rows and age into a picture. Lengths are pixels of
 * the picture from its middle, to the right and up.
 *
 * <p>Thread rule: immutable.
 */
public final class SpaceTimeProjection {
  /** Length of the time axis as a share of the sensor's longer side. */
  private static final double DEPTH = 1.6;

  private static final double MARGIN = 0.88;
  private final double cosTurn;
  private final double sinTurn;
  private final double cosTilt;
  private final double sinTilt;

  /** Pixels of the picture per pixel of the sensor. */
  private final double scale;

  private final double halfWidth;
  private final double halfHeight;

  /** Half of the time axis, pixels of the sensor. */
  private final double halfDepth;

  /** Length of a microsecond, pixels of the sensor. */
  private final double perUs;

  /**
   * A projection of a sensor, seen from a view, in which the whole box fits at zoom 1 into a
   * picture of a size in pixels without the room for names.
   */
  public SpaceTimeProjection(
      SpaceTimeView view, SensorGeometry sensor, double width, double height) {
    cosTurn = Math.cos(view.turnRad());
    sinTurn = Math.sin(view.turnRad());
    cosTilt = Math.cos(view.tiltRad());
    sinTilt = Math.sin(view.tiltRad());
    halfWidth = (sensor.width() - 1) / 2.0;
    halfHeight = (sensor.height() - 1) / 2.0;
    double depth = DEPTH * sensor.longerSide();
    halfDepth = depth / 2;
    perUs = depth / view.spanUs();
    double boxWidth = sensor.width() * Math.abs(cosTurn) + depth * Math.abs(sinTurn);
    double boxDepth = sensor.width() * Math.abs(sinTurn) + depth * Math.abs(cosTurn);
    double boxHeight = sensor.height() * Math.abs(cosTilt) + boxDepth * Math.abs(sinTilt);
    scale = view.zoom() * MARGIN * Math.min(width / boxWidth, height / boxHeight);
  }

  /** Place of a column at an age in microseconds to the right of the middle, pixels. */
  public double across(double x, double ageUs) {
    return ((x - halfWidth) * cosTurn + depth(ageUs) * sinTurn) * scale;
  }

  /** Place of a column and row, upwards, at an age in microseconds above the middle, pixels. */
  public double up(double x, double y, double ageUs) {
    return ((y - halfHeight) * cosTilt - away(x, ageUs) * sinTilt) * scale;
  }

  /** Nearness to the viewer; of two points at one position the larger one is visible. */
  double near(double x, double y, double ageUs) {
    return away(x, ageUs) * cosTilt + (y - halfHeight) * sinTilt;
  }

  private double away(double x, double ageUs) {
    return depth(ageUs) * cosTurn - (x - halfWidth) * sinTurn;
  }

  private double depth(double ageUs) {
    return halfDepth - ageUs * perUs;
  }
}
