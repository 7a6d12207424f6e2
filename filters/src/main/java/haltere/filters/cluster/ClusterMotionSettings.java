package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How events move a cluster, x ← (1 − m) x + m z, and its velocity: its motion, low-pass filtered.
 */
public record ClusterMotionSettings(
    @Help("Weight of an event: constant, lower at high event rates, or of a time constant.")
        Weight weight,
    @Help("With a weight per event, an event moves its cluster by this share of the distance.")
        @Range(min = 0.0001, max = 1, logarithmic = true)
        @Unit("1")
        double mixingFactor,
    @Help("With a weight per time, the location averages events over this time constant.")
        @Range(min = 2000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int mixingTimeUs,
    @Help("Clusters move by their velocity at each update.") boolean predict,
    @Help("The velocity is averaged over this time constant.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int velocityTimeUs,
    @Help("The velocity decays with this time constant; 0: it does not.")
        @Range(min = 0, max = 10_000_000)
        @Unit("us")
        int frictionTimeUs,
    @Help("Velocity at birth: zero, or the mean of the visible clusters.")
        StartVelocity startVelocity,
    @Help(
            "A cluster is no faster than the fastest visible one within this many radii; 0: no limit.")
        @Range(min = 0, max = 100)
        @Unit("1")
        double neighbourRadii) {
  /** Weight of an event. */
  public enum Weight {
    /** It is constant: Cardinale (2006), part I, eq. 1. */
    PER_EVENT,
    /** It is constant up to the visible rate of a pixel, and inverse to the rate above. */
    PER_EVENT_AND_RATE,
    /**
     * The location is the mean of the events weighted by exp(−age/τ): m = 1 / W with W ← 1 + W
     * exp(−Δt/τ), which at a constant rate tends to m = 1 − exp(−Δt/τ). Simultaneous events have
     * equal weights.
     */
    PER_TIME
  }

  /** Velocity at birth. */
  public enum StartVelocity {
    /** Zero. */
    ZERO,
    /** The mean velocity of the visible clusters. */
    MEAN
  }

  /** Checks the ranges. */
  public ClusterMotionSettings {
    SettingsSchema.validate(
        ClusterMotionSettings.class,
        weight,
        mixingFactor,
        mixingTimeUs,
        predict,
        velocityTimeUs,
        frictionTimeUs,
        startVelocity,
        neighbourRadii);
  }

  /**
   * {@return the default settings: a constant weight of 0.05, prediction with an average over 100
   * ms, no friction or limit}
   */
  public static ClusterMotionSettings defaults() {
    return new ClusterMotionSettings(
        Weight.PER_EVENT, 0.05, 20_000, true, 100_000, 0, StartVelocity.ZERO, 0);
  }
}
