package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How events move a cluster.
 *
 * @param mixing what decides the weight of an event
 * @param mixingFactor the weight, where it is constant
 * @param mixingTimeUs the time constant, where that is
 * @param longestMemoryUs the longest stretch that a line is fitted to, where the weight adapts
 * @param predict whether clusters move on with their velocity between events
 * @param velocity how fast it is taken to be
 */
public record ClusterMotionSettings(
    @Help("What decides the weight of an event: itself, the time, or how well a line fits.")
        Mixing mixing,
    @Help("With mixing per-event: an event moves its cluster by this share of the distance.")
        @Range(min = 0.0001, max = 1, logarithmic = true)
        @Unit("1")
        double mixingFactor,
    @Help("With mixing per-time: events count less and less with this time constant.")
        @Range(min = 2000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int mixingTimeUs,
    @Help("With mixing adaptive: straight motion is averaged over up to this time.")
        @Range(min = 5000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int longestMemoryUs,
    @Help("Clusters move on with their velocity between events.") boolean predict,
    ClusterVelocitySettings velocity) {
  /** What decides the weight of an event in the centre of its cluster. */
  public enum Mixing {
    /** Each event has the same weight: x = (1 - m) x + m z. */
    PER_EVENT,
    /**
     * As with {@link #PER_EVENT}, but where the pixels of a cluster fire faster than makes it
     * visible, the weight is inverse to their rate.
     */
    PER_EVENT_AND_RATE,
    /**
     * The centre is the mean of the events weighted by exp(-age / tau): m = 1 / W with W = 1 + W
     * exp(-dt / tau), which for events at equal intervals becomes 1 - exp(-dt / tau).
     */
    PER_TIME,
    /**
     * A line is fitted to the events of a memory, which is as long as a line fits: long where
     * motion is straight, short where it turns.
     */
    ADAPTIVE
  }

  /** Checks the ranges. */
  public ClusterMotionSettings {
    SettingsSchema.validate(
        ClusterMotionSettings.class,
        mixing,
        mixingFactor,
        mixingTimeUs,
        longestMemoryUs,
        predict,
        velocity);
  }

  /**
   * The default motion.
   *
   * @return adaptive, up to 300 ms, with prediction
   */
  public static ClusterMotionSettings defaults() {
    return new ClusterMotionSettings(
        Mixing.ADAPTIVE, 0.05, 20_000, 300_000, true, ClusterVelocitySettings.defaults());
  }
}
