package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Dependence of the size of clusters on their position: a camera above a road sees objects smaller
 * near the vanishing point.
 */
public record PerspectiveSettings(
    @Help("Clusters are smaller near the vanishing point.") boolean enabled,
    @Help("Column of the vanishing point as a share of the sensor's width.")
        @Range(min = -2, max = 3)
        @Unit("1")
        double vanishingX,
    @Help("Row of the vanishing point as a share of the sensor's height; 1 is the top.")
        @Range(min = -2, max = 3)
        @Unit("1")
        double vanishingY,
    @Help("Clusters are not scaled down to less than this.")
        @Range(min = 0.01, max = 1, logarithmic = true)
        @Unit("1")
        double minScale) {
  /** Checks the ranges. */
  public PerspectiveSettings {
    SettingsSchema.validate(PerspectiveSettings.class, enabled, vanishingX, vanishingY, minScale);
  }

  /** {@return the default settings: none; once enabled, towards the middle of the top row} */
  public static PerspectiveSettings defaults() {
    return new PerspectiveSettings(false, 0.5, 1, 0.1);
  }
}
