package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** Which clusters merge. */
public record ClusterMergingSettings(
    @Help("Clusters merge.") boolean allowed,
    @Help("Clusters merge when their boxes, scaled by this, overlap.")
        @Range(min = 0.1, max = 2)
        @Unit("1")
        double overlap,
    @Help("Clusters whose directions of motion differ by more do not merge; 180: all merge.")
        @Range(min = 10, max = 180)
        @Unit("deg")
        double differentAngleDeg,
    @Help("The merged cluster has the size of both together, not that of the heavier one.")
        boolean joinSize) {
  /** Checks the ranges. */
  public ClusterMergingSettings {
    SettingsSchema.validate(
        ClusterMergingSettings.class, allowed, overlap, differentAngleDeg, joinSize);
  }

  /**
   * {@return the default settings: boxes that overlap merge unless their directions differ by 60
   * degrees}
   */
  public static ClusterMergingSettings defaults() {
    return new ClusterMergingSettings(true, 1, 60, false);
  }
}
