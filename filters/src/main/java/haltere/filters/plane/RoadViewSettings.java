package haltere.filters.plane;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * View of a road from a bridge; see {@link RoadMapping}.
 *
 * @param vanishingPoint of the road in the picture
 */
public record RoadViewSettings(
    @Help("Height of the camera above the road.")
        @Range(min = 0.1, max = 1000, logarithmic = true)
        @Unit("m")
        double bridgeHeightM,
    @Help("Distance along the road seen by the bottom row of the picture.")
        @Range(min = 0.1, max = 250, logarithmic = true)
        @Unit("m")
        double nearestM,
    @Help("Distance along the road at the row of the vanishing point.")
        @Range(min = 2.5, max = 100_000, logarithmic = true)
        @Unit("m")
        double farthestM,
    VanishingPoint vanishingPoint) {
  /** Checks the ranges and that farthestM is greater than nearestM. */
  public RoadViewSettings {
    SettingsSchema.validate(
        RoadViewSettings.class, bridgeHeightM, nearestM, farthestM, vanishingPoint);
    if (farthestM <= nearestM) {
      throw new SettingsProblem(
          "farthestM must be greater than nearestM, "
              + farthestM
              + " m is not beyond "
              + nearestM
              + " m");
    }
  }

  /**
   * {@return the default settings, those of Cardinale (2006): 5 m high, 2 m to 300 m, no vanishing
   * point marked}
   */
  public static RoadViewSettings defaults() {
    return new RoadViewSettings(5, 2, 300, VanishingPoint.defaults());
  }
}
