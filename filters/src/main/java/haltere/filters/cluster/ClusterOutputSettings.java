package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * What a cluster tracker keeps and tells.
 *
 * @param mostClusters how many clusters there may be
 * @param upkeepUs how often clusters are attended to
 * @param reportRateHz how often the visible clusters are reported
 * @param pathPoints positions that a trail has
 * @param onlyClustered whether events outside visible clusters are taken out of the stream
 */
public record ClusterOutputSettings(
    @Help("There are no more clusters than this at a time.")
        @Range(min = 1, max = 200, logarithmic = true)
        @Unit("clusters")
        int mostClusters,
    @Help("Births, deaths, sizes and mergers are attended to at this interval of event time.")
        @Range(min = 100, max = 100_000, logarithmic = true)
        @Unit("us")
        int upkeepUs,
    @Help("The visible clusters are reported at this rate of recording time.")
        @Range(min = 1, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz,
    @Help("A trail has up to this many positions, one a report.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("positions")
        int pathPoints,
    @Help("Only events within visible clusters are passed on.") boolean onlyClustered) {
  /** Checks the ranges. */
  public ClusterOutputSettings {
    SettingsSchema.validate(
        ClusterOutputSettings.class,
        mostClusters,
        upkeepUs,
        reportRateHz,
        pathPoints,
        onlyClustered);
  }

  /**
   * The default.
   *
   * @return 40 clusters, attended to each millisecond, reported at 100 Hz, a second of trail
   */
  public static ClusterOutputSettings defaults() {
    return new ClusterOutputSettings(40, 1000, 100, 100, false);
  }
}
