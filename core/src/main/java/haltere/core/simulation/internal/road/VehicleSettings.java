package haltere.core.simulation.internal.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The vehicles of {@link RoadScene}. The weights of the kinds are relative to one another; if all
 * are 0 every vehicle is a car, but for those that an encounter asks for.
 *
 * @param heightShare height as a share of that of the kind; 0 makes vehicles flat, so that a map
 *     from pixels to the road has no bias
 * @param contrast contrast of a body to the road, natural logarithm of the light; two of three
 *     vehicles are darker than the road
 */
public record VehicleSettings(
    @Help("Weight of the cars.") @Range(min = 0, max = 100) @Unit("1") double cars,
    @Help("Weight of the lorries.") @Range(min = 0, max = 100) @Unit("1") double lorries,
    @Help("Weight of the motorcycles.") @Range(min = 0, max = 100) @Unit("1") double motorcycles,
    @Help("Largest deviation of a size from that of its kind.")
        @Range(min = 0, max = 0.2)
        @Unit("1")
        double sizeSpread,
    @Help("Height as a share of that of the kind, 0 for flat vehicles.")
        @Range(min = 0, max = 1)
        @Unit("1")
        double heightShare,
    @Help("Contrast of a body to the road.") @Range(min = 0, max = 3) @Unit("ln") double contrast,
    @Help("Standard deviation of the contrast over the vehicles, as a share of it.")
        @Range(min = 0, max = 0.5)
        @Unit("1")
        double contrastSpread,
    @Help("Contrast of windows, lamps and the like, 0 for uniform bodies.")
        @Range(min = 0, max = 2)
        @Unit("1")
        double texture) {
  /** Checks the values. */
  public VehicleSettings {
    SettingsSchema.validate(
        VehicleSettings.class,
        cars,
        lorries,
        motorcycles,
        sizeSpread,
        heightShare,
        contrast,
        contrastSpread,
        texture);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static VehicleSettings defaults() {
    return new VehicleSettings(6, 2, 2, 0.08, 1, 0.7, 0.2, 1);
  }
}
