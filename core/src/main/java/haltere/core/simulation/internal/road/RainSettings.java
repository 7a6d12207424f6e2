package haltere.core.simulation.internal.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Rain in front of the camera: bright drops that fall through the picture, each a short streak of
 * ON events with OFF events behind.
 */
public record RainSettings(
    @Help("Streaks of rain per second, 0 for dry weather.")
        @Range(min = 0, max = 100000, logarithmic = true)
        @Unit("streaks/s")
        double streaksPerS,
    @Help("Mean length of a streak.") @Range(min = 1, max = 200, logarithmic = true) @Unit("px")
        double lengthPx,
    @Help("Mean speed of a drop.") @Range(min = 500, max = 100000, logarithmic = true) @Unit("px/s")
        double speedPxS,
    @Help("Motion of a drop to the right per unit of its fall.")
        @Range(min = -1, max = 1)
        @Unit("1")
        double slant) {
  /** Checks the values. */
  public RainSettings {
    SettingsSchema.validate(RainSettings.class, streaksPerS, lengthPx, speedPxS, slant);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RainSettings defaults() {
    return new RainSettings(0, 8, 1500, 0.15);
  }
}
