package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The velocity of a cluster.
 *
 * @param timeUs time constant of its mean, where the weight of events does not adapt
 * @param frictionTimeUs time constant with which it decays by itself, 0 for never
 * @param start what a newborn cluster begins with
 * @param neighbourRadii how far away neighbours are that limit it, 0 for no limit
 */
public record ClusterVelocitySettings(
    @Help("With mixing other than adaptive: the velocity is averaged over about this time.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int timeUs,
    @Help("Without events a velocity decays with this time constant; 0: it does not.")
        @Range(min = 0, max = 10_000_000)
        @Unit("us")
        int frictionTimeUs,
    @Help(
            "Velocity that a newborn cluster begins with: none, the mean of the visible ones, or that"
                + " of the events that made it.")
        Start start,
    @Help(
            "No cluster is faster than the fastest visible one within this many times both radii; 0:"
                + " no limit.")
        @Range(min = 0, max = 100)
        @Unit("1")
        double neighbourRadii) {
  /** Velocity of a newborn cluster. */
  public enum Start {
    /** None. */
    ZERO,
    /** The mean velocity of the visible clusters. */
    MEAN,
    /** The slope of a line through the events that made it, a rough estimate. */
    EVENTS
  }

  /** Checks the ranges. */
  public ClusterVelocitySettings {
    SettingsSchema.validate(
        ClusterVelocitySettings.class, timeUs, frictionTimeUs, start, neighbourRadii);
  }

  /**
   * The default velocity.
   *
   * @return 100 ms, no friction, none at birth, no limit
   */
  public static ClusterVelocitySettings defaults() {
    return new ClusterVelocitySettings(100_000, 0, Start.ZERO, 0);
  }
}
