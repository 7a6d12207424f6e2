package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * When there is a cluster, when it is visible, and when it is no more.
 *
 * @param birthEvents recent events at a place that make a cluster
 * @param recentUs how long an event counts as recent
 * @param visibleBy what makes a cluster visible
 * @param visibleMass recent events that make it visible
 * @param visibleRateHz event rate of a pixel that makes it visible
 * @param leastSpeedPxPerS slower ones are not visible
 * @param lifetimeUs how long it lives without support
 * @param border when a cluster dies at the sensor's border
 */
public record ClusterLifeSettings(
    @Help("As many recent events at a place, more than noise makes, begin a cluster.")
        @Range(min = 2, max = 10_000, logarithmic = true)
        @Unit("events")
        double birthEvents,
    @Help("An event counts less and less with this time constant.")
        @Range(min = 2000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int recentUs,
    @Help("What makes a cluster visible: recent events, or the event rate of its pixels.")
        Visibility visibleBy,
    @Help("With visible-by mass: a cluster is visible once it has this many recent events.")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("events")
        double visibleMass,
    @Help("With visible-by rate: a cluster is visible once its pixels fire at this rate, in mean.")
        @Range(min = 0.01, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double visibleRateHz,
    @Help("A cluster becomes visible only when it is at least as fast; 0: all do.")
        @Range(min = 0, max = 100_000)
        @Unit("px/s")
        double leastSpeedPxPerS,
    @Help("A cluster that has had hardly any events for longer than this dies.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int lifetimeUs,
    @Help("Whether a cluster dies at the border: never, with its centre outside, or touching it.")
        Border border) {
  /** What makes a cluster visible. */
  public enum Visibility {
    /** Recent events. */
    MASS,
    /** Event rate over the pixels within the cluster. */
    RATE
  }

  /** When a cluster dies at the sensor's border. */
  public enum Border {
    /** Never. */
    NEVER,
    /** When its centre is outside. */
    CENTRE,
    /** When its outline is. */
    OUTLINE
  }

  /** Checks the ranges. */
  public ClusterLifeSettings {
    SettingsSchema.validate(
        ClusterLifeSettings.class,
        birthEvents,
        recentUs,
        visibleBy,
        visibleMass,
        visibleRateHz,
        leastSpeedPxPerS,
        lifetimeUs,
        border);
  }

  /**
   * The default life.
   *
   * @return born of 8 events in 50 ms, visible at 12, dead 100 ms after the last, or at the border
   */
  public static ClusterLifeSettings defaults() {
    return new ClusterLifeSettings(8, 50_000, Visibility.MASS, 12, 10, 0, 100_000, Border.CENTRE);
  }
}
