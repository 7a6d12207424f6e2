package haltere.core.simulation.internal.dots;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The dots of {@link MovingDotsScene}: dark discs in front of a bright background. */
public record DotSettings(
    @Help("Motion of the dots.") DotPath path,
    @Help("Number of dots.") @Range(min = 1, max = 50) @Unit("dots") int count,
    @Help("Radius of a dot.") @Range(min = 0.5, max = 50, logarithmic = true) @Unit("px")
        double radiusPx,
    @Help("Speed of a dot along its path.")
        @Range(min = 0, max = 100000, logarithmic = true)
        @Unit("px/s")
        double speedPxS,
    @Help("Mean number of events of a pixel when the edge of a dot passes.")
        @Range(min = 0, max = 20, logarithmic = true)
        @Unit("events")
        double eventsPerPixel) {
  /** Checks the values. */
  public DotSettings {
    SettingsSchema.validate(DotSettings.class, path, count, radiusPx, speedPxS, eventsPerPixel);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static DotSettings defaults() {
    return new DotSettings(DotPath.CIRCLES, 4, 3, 150, 1);
  }
}
