package haltere.filters.plane;

import haltere.core.event.SensorGeometry;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The vanishing point of a road in the picture. */
public record VanishingPoint(
    @Help("On: the marked vanishing point. Off: the middle of the top row.") boolean marked,
    @Help("Column of the marked vanishing point, which may be outside of the sensor.")
        @Range(min = -32767, max = 32767)
        @Unit("px")
        double xPx,
    @Help("Row of the marked vanishing point, counted from the bottom row.")
        @Range(min = 1, max = 32767)
        @Unit("px")
        double yPx) {
  /** Checks the ranges. */
  public VanishingPoint {
    SettingsSchema.validate(VanishingPoint.class, marked, xPx, yPx);
  }

  /**
   * {@return the default settings: no mark; its values are the middle of the top row of 128 x 128
   * pixels}
   */
  public static VanishingPoint defaults() {
    return new VanishingPoint(false, 63.5, 127);
  }

  /**
   * {@return a mark, such as a click}
   *
   * @param xPx column, pixels
   * @param yPx row above the bottom row, pixels
   */
  public static VanishingPoint at(double xPx, double yPx) {
    return new VanishingPoint(true, xPx, yPx);
  }

  /**
   * {@return this point if it is marked, else the middle of the sensor's top row}
   *
   * @param sensor the sensor
   * @throws haltere.core.settings.SettingsProblem if nothing is marked and there is one row only
   */
  VanishingPoint on(SensorGeometry sensor) {
    return marked ? this : at((sensor.width() - 1) / 2.0, sensor.height() - 1);
  }
}
