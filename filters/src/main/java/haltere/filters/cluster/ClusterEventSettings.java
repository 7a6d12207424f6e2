package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.filters.selection.PolaritySettings.Keep;

/** Events that are assigned to a cluster, and effect of those at its edge. */
public record ClusterEventSettings(
    @Help("Polarity of the events that count; the others are ignored.") Keep polarity,
    @Help("An event in the surround takes this mass away instead of adding one; 0: it adds one.")
        @Range(min = 0, max = 100)
        @Unit("events")
        double inhibition,
    @Help("Only events within this share of the radius from the edge move a cluster; 0: all do.")
        @Range(min = 0, max = 1)
        @Unit("1")
        double edgeThickness) {
  /** Checks the ranges. */
  public ClusterEventSettings {
    SettingsSchema.validate(ClusterEventSettings.class, polarity, inhibition, edgeThickness);
  }

  /** {@return the default settings: both polarities, no inhibition, events anywhere} */
  public static ClusterEventSettings defaults() {
    return new ClusterEventSettings(Keep.BOTH, 0, 0);
  }
}
