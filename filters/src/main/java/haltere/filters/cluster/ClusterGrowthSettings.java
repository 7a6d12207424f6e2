package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Adaptation of the shape to the second moments of the events, which are averaged with the weights
 * of the location.
 */
public record ClusterGrowthSettings(
    @Help(value = "The radius adapts to the spread of the events.", label = "Adaptive size")
        boolean size,
    @Help(
            value = "The ratio of the half axes adapts to the spread of the events.",
            label = "Adaptive aspect ratio")
        boolean aspect,
    @Help("Size range (factor): how much a radius may grow or shrink from the a-priori one.")
        @Range(min = 1, max = 30, logarithmic = true)
        @Unit("1")
        double maxScale,
    @Help("While the size adapts, a cluster captures events up to this many radii away.")
        @Range(min = 1, max = 5)
        @Unit("1")
        double surround) {
  /** Checks the ranges. */
  public ClusterGrowthSettings {
    SettingsSchema.validate(ClusterGrowthSettings.class, size, aspect, maxScale, surround);
  }

  /**
   * {@return the default settings: no adaptation; once it is on, by up to a factor of 4, with a
   * surround of 2}
   */
  public static ClusterGrowthSettings defaults() {
    return new ClusterGrowthSettings(false, false, 4, 2);
  }
}
