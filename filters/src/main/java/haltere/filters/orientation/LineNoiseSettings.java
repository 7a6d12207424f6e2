package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How sure an observed angle is.
 *
 * @param angleSdDeg standard deviation to begin with
 * @param calibrate whether that of each camera is learnt
 * @param byEccentricity whether round detections count for less
 */
public record LineNoiseSettings(
    @Help("Standard deviation of an observed angle, to begin with.")
        @Range(min = 0.01, max = 1000, logarithmic = true)
        @Unit("deg")
        double angleSdDeg,
    @Help("Whether the standard deviation of each camera is learnt from its own detections.")
        boolean calibrate,
    @Help("Whether a detection counts for less the rounder it is.") boolean byEccentricity) {
  /** Checks the ranges. */
  public LineNoiseSettings {
    SettingsSchema.validate(LineNoiseSettings.class, angleSdDeg, calibrate, byEccentricity);
  }

  /**
   * The settings to start from.
   *
   * @return two degrees, learnt
   */
  public static LineNoiseSettings defaults() {
    return new LineNoiseSettings(2, true, false);
  }
}
