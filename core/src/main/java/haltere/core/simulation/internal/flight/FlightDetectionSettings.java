package haltere.core.simulation.internal.flight;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The detections of {@link FlightScene} and their errors. */
public record FlightDetectionSettings(
    @Help("Pictures per second.") @Range(min = 1, max = 100000, logarithmic = true) @Unit("Hz")
        double rateHz,
    @Help("Standard deviation of a detected angle.") @Range(min = 0, max = 90) @Unit("deg")
        double angleSdDeg,
    @Help("Standard deviation of a detected position, in each coordinate.")
        @Range(min = 0, max = 100)
        @Unit("px")
        double placeSdPx,
    @Help("Share of angles that are outliers.") @Range(min = 0, max = 1) @Unit("1")
        double outlierShare,
    @Help("Minimum error of an outlier; larger errors are equally likely.")
        @Range(min = 0, max = 90)
        @Unit("deg")
        double outlierDeg,
    @Help("Share of missing detections.") @Range(min = 0, max = 1) @Unit("1") double missingShare) {
  /** Checks the ranges. */
  public FlightDetectionSettings {
    SettingsSchema.validate(
        FlightDetectionSettings.class,
        rateHz,
        angleSdDeg,
        placeSdPx,
        outlierShare,
        outlierDeg,
        missingShare);
  }

  /**
   * The default settings.
   *
   * @return 100 Hz, 2 degrees, half a pixel, one outlier in ten, one missing in twenty
   */
  public static FlightDetectionSettings defaults() {
    return new FlightDetectionSettings(100, 2, 0.5, 0.1, 20, 0.05);
  }
}
