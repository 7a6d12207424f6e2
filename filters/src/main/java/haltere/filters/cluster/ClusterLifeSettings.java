package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** Support, visibility and death of clusters. */
public record ClusterLifeSettings(
    @Help("Mass: events of a cluster, each of which decays with this time constant.")
        @Range(min = 2000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int massTimeUs,
    @Help("A cluster, newborn or not, dies after this time without support.")
        @Range(min = 1000, max = 10_000_000, logarithmic = true)
        @Unit("us")
        int lifetimeUs,
    @Help("Support, which makes a cluster visible: its mass, or the event rate of its pixels.")
        Support supportedBy,
    @Help("Mass from which on a cluster is visible, if that is its support.")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("events")
        double visibleMass,
    @Help("Mean event rate of a pixel from which on a cluster is visible, if that is its support.")
        @Range(min = 0.01, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double visibleRateHz,
    @Help("Slower clusters are not visible; 0: all are.")
        @Range(min = 0, max = 100_000)
        @Unit("px/s")
        double minSpeedPxS,
    @Help("A cluster dies at the border: never, with its centre outside, or touching it.")
        Border border) {
  /** Criterion for the support and visibility of a cluster. */
  public enum Support {
    /** Its mass. */
    MASS,
    /** The mean event rate of its pixels. */
    RATE
  }

  /** When a cluster dies at the sensor's border. */
  public enum Border {
    /** Never. */
    NEVER,
    /** With its centre outside. */
    CENTRE,
    /** With any part of it outside. */
    OUTLINE
  }

  /** Checks the ranges. */
  public ClusterLifeSettings {
    SettingsSchema.validate(
        ClusterLifeSettings.class,
        massTimeUs,
        lifetimeUs,
        supportedBy,
        visibleMass,
        visibleRateHz,
        minSpeedPxS,
        border);
  }

  /**
   * {@return the default settings: visible from 3 Hz of a pixel on, averaged over 50 ms, which
   * noise of 1 Hz does not reach and which does not depend on the sensor; dead after 20 ms without
   * that or at the border}
   */
  public static ClusterLifeSettings defaults() {
    return new ClusterLifeSettings(50_000, 20_000, Support.RATE, 10, 3, 0, Border.CENTRE);
  }
}
