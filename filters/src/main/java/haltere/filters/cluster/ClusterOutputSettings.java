package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** Bounds and results of a cluster tracker. */
public record ClusterOutputSettings(
    @Help("Largest number of clusters at a time; at this number none is born.")
        @Range(min = 1, max = 200, logarithmic = true)
        @Unit("clusters")
        int maxClusters,
    @Help("Interval of event time at which clusters are predicted, merged and removed.")
        @Range(min = 100, max = 100_000, logarithmic = true)
        @Unit("us")
        int updateIntervalUs,
    @Help("Visible clusters are reported at this rate of recording time.")
        @Range(min = 0.001, max = 100_000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz,
    @Help("A path has up to this many positions, one a report.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("positions")
        int pathPoints,
    @Help("Only events in visible clusters are passed on.") boolean onlyClustered) {
  /** Checks the ranges. */
  public ClusterOutputSettings {
    SettingsSchema.validate(
        ClusterOutputSettings.class,
        maxClusters,
        updateIntervalUs,
        reportRateHz,
        pathPoints,
        onlyClustered);
  }

  /**
   * {@return the default settings: 20 clusters, updated each millisecond, 100 reports a second with
   * a second of path}
   */
  public static ClusterOutputSettings defaults() {
    return new ClusterOutputSettings(20, 1000, 100, 100, false);
  }
}
