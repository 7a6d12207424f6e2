package haltere.ui.rendering;

import haltere.core.event.SensorGeometry;

/**
 * Parallel projection of sensor columns, sensor rows and age into a picture. Lengths are pixels of
 * the picture from its middle, to the right and up.
 *
 * @param cosTurn cosine of the turn around the sensor's vertical
 * @param sinTurn its sine
 * @param cosTilt cosine of the tilt
 * @param sinTilt its sine
 * @param scale pixels of the picture per pixel of the sensor
 * @param halfWidth half of the sensor's columns
 * @param halfHeight half of the sensor's rows
 * @param halfDepth half of the time axis, pixels of the sensor
 * @param perUs length of a microsecond, pixels of the sensor
 */
public record SpaceTimeProjection(
    double cosTurn,
    double sinTurn,
    double cosTilt,
    double sinTilt,
    double scale,
    double halfWidth,
    double halfHeight,
    double halfDepth,
    double perUs) {
  /** Length of the time axis as a share of the sensor's longer side. */
  private static final double DEPTH = 1.6;

  private static final double MARGIN = 0.88;

  /**
   * A projection in which the whole box fits at zoom 1.
   *
   * @param view from where it is looked at
   * @param sensor columns and rows
   * @param width of the picture without the room for names, pixels
   * @param height of the picture without the room for names, pixels
   * @return the projection
   */
  public static SpaceTimeProjection of(
      SpaceTimeView view, SensorGeometry sensor, double width, double height) {
    double cosTurn = Math.cos(view.turnRad());
    double sinTurn = Math.sin(view.turnRad());
    double cosTilt = Math.cos(view.tiltRad());
    double sinTilt = Math.sin(view.tiltRad());
    double depth = DEPTH * sensor.longerSide();
    double boxWidth = sensor.width() * Math.abs(cosTurn) + depth * Math.abs(sinTurn);
    double boxDepth = sensor.width() * Math.abs(sinTurn) + depth * Math.abs(cosTurn);
    double boxHeight = sensor.height() * Math.abs(cosTilt) + boxDepth * Math.abs(sinTilt);
    return new SpaceTimeProjection(
        cosTurn,
        sinTurn,
        cosTilt,
        sinTilt,
        view.zoom() * MARGIN * Math.min(width / boxWidth, height / boxHeight),
        (sensor.width() - 1) / 2.0,
        (sensor.height() - 1) / 2.0,
        depth / 2,
        depth / view.spanUs());
  }

  /**
   * Place to the right of the middle.
   *
   * @param x column
   * @param ageUs age, microseconds
   * @return pixels
   */
  public double across(double x, double ageUs) {
    return ((x - halfWidth) * cosTurn + depth(ageUs) * sinTurn) * scale;
  }

  /**
   * Place above the middle.
   *
   * @param x column
   * @param y row, upwards
   * @param ageUs age, microseconds
   * @return pixels
   */
  public double up(double x, double y, double ageUs) {
    return ((y - halfHeight) * cosTilt - away(x, ageUs) * sinTilt) * scale;
  }

  /** Nearness to the looker; of two points at one place the larger one is seen. */
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
