package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link ClusterTracker}.
 *
 * @param mixingFactor weight of each event in the centre
 * @param clusterSize radius as a share of the sensor's longer side
 * @param mostClusters how many clusters there may be
 * @param lifetimeUs how long a cluster lives without an event
 * @param visibleEvents recent events that make a cluster visible
 * @param visibleTimeUs how long an event counts as recent
 * @param velocityTimeUs time constant of the velocity
 * @param reportRateHz how often the visible clusters are reported
 */
public record ClusterTrackerSettings(
    @Help("Each event moves its cluster by this share of the distance between them.")
        @Range(min = 0.0001, max = 1, logarithmic = true)
        @Unit("1")
        double mixingFactor,
    @Help("Radius of a cluster as a share of the longer side of the sensor.")
        @Range(min = 0.005, max = 0.5, logarithmic = true)
        @Unit("1")
        double clusterSize,
    @Help("There are no more clusters than this at a time, visible ones and candidates together.")
        @Range(min = 1, max = 200, logarithmic = true)
        @Unit("clusters")
        int mostClusters,
    @Help("A cluster that gets no event for longer than this dies.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int lifetimeUs,
    @Help("A cluster is shown once it has this many recent events.")
        @Range(min = 1, max = 10_000, logarithmic = true)
        @Unit("events")
        double visibleEvents,
    @Help("For the visibility an event counts less and less with this time constant.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int visibleTimeUs,
    @Help("The velocity is averaged over about this time.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int velocityTimeUs,
    @Help("The visible clusters are reported at this rate of recording time.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz) {
  /** Checks the ranges. */
  public ClusterTrackerSettings {
    SettingsSchema.validate(
        ClusterTrackerSettings.class,
        mixingFactor,
        clusterSize,
        mostClusters,
        lifetimeUs,
        visibleEvents,
        visibleTimeUs,
        velocityTimeUs,
        reportRateHz);
  }

  /**
   * The settings to start from. A circle of a tenth of a sensor of 128 x 128 pixels holds 515
   * pixels, so noise of 1 Hz a pixel that nobody has filtered gives a candidate 10 events in 20 ms,
   * and 30 are out of its reach. The lifetime lets a pendulum turn.
   *
   * @return 0.02 an event, a tenth of the sensor, 10 clusters, 100 ms, 30 events in 20 ms, 50 ms,
   *     100 Hz
   */
  public static ClusterTrackerSettings defaults() {
    return new ClusterTrackerSettings(0.02, 0.1, 10, 100_000, 30, 20_000, 50_000, 100);
  }
}
