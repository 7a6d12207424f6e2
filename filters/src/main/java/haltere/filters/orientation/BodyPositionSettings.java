package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How the body moves, and when it is lost.
 *
 * @param pixelSd standard deviation of an observed place
 * @param accelerationDensity how much the velocity wanders
 * @param gateSigmas which places are used
 * @param togetherS how far apart in time cameras may look and still be taken together at the start
 * @param longestGapS when a body that nobody saw is lost
 */
public record BodyPositionSettings(
    @Help("Standard deviation of a detection's place in the picture, in each coordinate.")
        @Range(min = 0.001, max = 1000, logarithmic = true)
        @Unit("px")
        double pixelSd,
    @Help("Spectral density of the body's acceleration.")
        @Range(min = 1e-9, max = 1e9, logarithmic = true)
        @Unit("m^2/s^3")
        double accelerationDensity,
    @Help("A place is used if it is within so many standard deviations of the expected one.")
        @Range(min = 1, max = 30)
        @Unit("sigma")
        double gateSigmas,
    @Help("Views of two cameras that are no further apart in time may start a body.")
        @Range(min = 0, max = 10)
        @Unit("s")
        double togetherS,
    @Help("A body that was not seen for longer begins anew.")
        @Range(min = 0.001, max = 1000, logarithmic = true)
        @Unit("s")
        double longestGapS) {
  /** Checks the ranges. */
  public BodyPositionSettings {
    SettingsSchema.validate(
        BodyPositionSettings.class,
        pixelSd,
        accelerationDensity,
        gateSigmas,
        togetherS,
        longestGapS);
  }

  /**
   * The settings to start from.
   *
   * @return an insect in metres
   */
  public static BodyPositionSettings defaults() {
    return new BodyPositionSettings(1, 2, 5, 0.02, 0.5);
  }
}
