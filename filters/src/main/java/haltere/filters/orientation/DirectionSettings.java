package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How head and tail are told apart.
 *
 * @param memoryS how long the way flown counts
 * @param doubtSigmas how clear the opposite must be before the decision is changed
 * @param certaintySigmas how clear the decision can become
 * @param slipSdDeg how far the head is off the direction of flight
 */
public record DirectionSettings(
    @Help("Time constant with which the way that the body has flown along its axis is forgotten.")
        @Range(min = 0.01, max = 1000, logarithmic = true)
        @Unit("s")
        double memoryS,
    @Help(
            "Head and tail are exchanged when the way flown backwards is so many times its standard"
                + " deviation.")
        @Range(min = 0, max = 100)
        @Unit("sigma")
        double doubtSigmas,
    @Help("The way flown forwards counts up to so many times its standard deviation.")
        @Range(min = 1, max = 1000)
        @Unit("sigma")
        double certaintySigmas,
    @Help(
            "Standard deviation of the angle between axis and flight; it helps where cameras do not"
                + " tell the axis, and only there. 90 leaves the flight out.")
        @Range(min = 5, max = 90)
        @Unit("deg")
        double slipSdDeg) {
  /** Checks the ranges. */
  public DirectionSettings {
    SettingsSchema.validate(
        DirectionSettings.class, memoryS, doubtSigmas, certaintySigmas, slipSdDeg);
  }

  /**
   * The settings to start from.
   *
   * @return half a second, two standard deviations to change, at most twelve; 50 degrees
   */
  public static DirectionSettings defaults() {
    return new DirectionSettings(0.5, 2, 12, 50);
  }
}
