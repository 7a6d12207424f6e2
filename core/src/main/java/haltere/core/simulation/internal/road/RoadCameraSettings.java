package haltere.core.simulation.internal.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The camera on the bridge of {@link RoadScene}: what maps the road to pixels. */
public record RoadCameraSettings(
    @Help("Height of the camera above the road.")
        @Range(min = 4.5, max = 100, logarithmic = true)
        @Unit("m")
        double bridgeHeightM,
    @Help("Distance along the road seen by the bottom row.")
        @Range(min = 0.5, max = 20, logarithmic = true)
        @Unit("m")
        double bottomRowM,
    @Help("Distance along the road at the row of the vanishing point.")
        @Range(min = 30, max = 5000, logarithmic = true)
        @Unit("m")
        double vanishingRowM,
    @Help("Column of the vanishing point: 0 is the first, 1 the last.")
        @Range(min = 0, max = 1)
        @Unit("1")
        double vanishingX,
    @Help("Row of the vanishing point: 0 is the bottom, 1 the top.")
        @Range(min = 0.2, max = 1)
        @Unit("1")
        double vanishingY) {
  /** Checks the values. */
  public RoadCameraSettings {
    SettingsSchema.validate(
        RoadCameraSettings.class, bridgeHeightM, bottomRowM, vanishingRowM, vanishingX, vanishingY);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RoadCameraSettings defaults() {
    return new RoadCameraSettings(5, 6, 300, 0.5, 1);
  }
}
