package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.filters.selection.PolaritySettings;

/**
 * Which events count for clusters, and how.
 *
 * @param polarity events of which polarity
 * @param edges whether the two polarities may lie at two places, as those of two edges do
 * @param inhibition what an event in the surround takes from the mass
 * @param edgeThickness how far from its outline events move a cluster, as a share of its radius
 */
public record ClusterEventSettings(
    @Help("Events of which polarity count; the others go by.") PolaritySettings.Keep polarity,
    @Help("The centre is half way between the ON and the OFF events, not their mean.")
        boolean edges,
    @Help("An event around a cluster, not in it, takes this many events from its mass; 0: none.")
        @Range(min = 0, max = 100)
        @Unit("events")
        double inhibition,
    @Help(
            "Only events within this share of the radius from the outline move a cluster and give it"
                + " its size; 0: all do.")
        @Range(min = 0, max = 1)
        @Unit("1")
        double edgeThickness) {
  /** Checks the ranges. */
  public ClusterEventSettings {
    SettingsSchema.validate(ClusterEventSettings.class, polarity, edges, inhibition, edgeThickness);
  }

  /**
   * The default.
   *
   * @return both polarities, edges told apart, no inhibition, events anywhere
   */
  public static ClusterEventSettings defaults() {
    return new ClusterEventSettings(PolaritySettings.Keep.BOTH, true, 0, 0);
  }
}
