package haltere.filters.selection;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link RegionFilter}.
 *
 * @since 0.1
 */
public record RegionSettings(
    @Help("First column of the rectangle, 0 at the left.")
        @Range(min = 0, max = RegionSettings.MAX_PX)
        @Unit("px")
        int leftPx,
    @Help("First row of the rectangle, 0 at the bottom.")
        @Range(min = 0, max = RegionSettings.MAX_PX)
        @Unit("px")
        int bottomPx,
    @Help("Number of columns; columns outside of the sensor are ignored.")
        @Range(min = 0, max = RegionSettings.MAX_PX)
        @Unit("px")
        int widthPx,
    @Help("Number of rows; rows outside of the sensor are ignored.")
        @Range(min = 0, max = RegionSettings.MAX_PX)
        @Unit("px")
        int heightPx,
    @Help(value = "Events inside or outside of the rectangle pass.", label = "Passing events")
        RegionSide keep) {
  /** Largest size, above that of any sensor. */
  static final int MAX_PX = 32_768;

  /** Which events pass. */
  public enum RegionSide {
    /** Those in the rectangle. */
    INSIDE,
    /** All others. */
    OUTSIDE
  }

  /** Checks the ranges. */
  public RegionSettings {
    SettingsSchema.validate(RegionSettings.class, leftPx, bottomPx, widthPx, heightPx, keep);
  }

  /**
   * The default settings.
   *
   * @return the inside of a rectangle that contains any sensor
   */
  public static RegionSettings defaults() {
    return new RegionSettings(0, 0, MAX_PX, MAX_PX, RegionSide.INSIDE);
  }
}
