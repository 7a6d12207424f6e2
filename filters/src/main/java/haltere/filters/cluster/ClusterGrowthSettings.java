package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How clusters take on the size of what they follow.
 *
 * @param size whether the size follows the spread of the events
 * @param aspect whether the ratio of the half axes does
 * @param mostScale by how much a radius may differ from the one to begin with
 * @param surround how much larger than the cluster the region is whose events it takes
 * @param events over how many events the spread is averaged
 */
public record ClusterGrowthSettings(
    @Help("The size of a cluster follows the spread of its events.") boolean size,
    @Help("The ratio of a cluster's half axes follows the spread of its events.") boolean aspect,
    @Help("A radius stays between the one to begin with over this, and times this.")
        @Range(min = 1, max = 30, logarithmic = true)
        @Unit("1")
        double mostScale,
    @Help("While the size follows, events up to this many radii away belong to the cluster.")
        @Range(min = 1, max = 5)
        @Unit("1")
        double surround,
    @Help("The spread is averaged over about this many events.")
        @Range(min = 5, max = 10_000, logarithmic = true)
        @Unit("events")
        double events) {
  /** Checks the ranges. */
  public ClusterGrowthSettings {
    SettingsSchema.validate(ClusterGrowthSettings.class, size, aspect, mostScale, surround, events);
  }

  /**
   * The default growth.
   *
   * @return the size follows 100 events, up to 6 times larger or smaller
   */
  public static ClusterGrowthSettings defaults() {
    return new ClusterGrowthSettings(true, false, 6, 1.3, 100);
  }
}
