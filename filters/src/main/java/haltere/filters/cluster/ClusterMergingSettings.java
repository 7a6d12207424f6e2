package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Which clusters become one.
 *
 * @param allowed whether any do
 * @param overlap how near two of the same motion must be
 * @param differentAngleDeg directions of motion that differ by more are those of two things
 * @param seenTogetherUs how long two must have been near, in the same motion
 * @param seenApartUs the same for two that were seen apart before
 * @param joinSize whether the size of both together is taken on
 */
public record ClusterMergingSettings(
    @Help("Clusters may merge.") boolean allowed,
    @Help("Clusters may merge when their centres are nearer than this share of both radii.")
        @Range(min = 0.1, max = 2)
        @Unit("1")
        double overlap,
    @Help("Clusters whose directions of motion differ by more do not merge; 180: all do.")
        @Range(min = 10, max = 180)
        @Unit("deg")
        double differentAngleDeg,
    @Help("Clusters merge after they have been near each other for this time, in one motion.")
        @Range(min = 0, max = 10_000_000)
        @Unit("us")
        int seenTogetherUs,
    @Help("The same time for clusters that have been seen apart from each other before.")
        @Range(min = 0, max = 100_000_000)
        @Unit("us")
        int seenApartUs,
    @Help("The merged cluster takes on the size of both together, not that of the heavier one.")
        boolean joinSize) {
  /** Checks the ranges. */
  public ClusterMergingSettings {
    SettingsSchema.validate(
        ClusterMergingSettings.class,
        allowed,
        overlap,
        differentAngleDeg,
        seenTogetherUs,
        seenApartUs,
        joinSize);
  }

  /**
   * The default rule.
   *
   * @return near at 0.6 of both radii, 60 degrees, 20 ms, 1 s, sizes joined
   */
  public static ClusterMergingSettings defaults() {
    return new ClusterMergingSettings(true, 0.6, 60, 20_000, 1_000_000, true);
  }
}
