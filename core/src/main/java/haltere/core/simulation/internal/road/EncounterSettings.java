package haltere.core.simulation.internal.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The behaviour of the groups of vehicles of {@link RoadScene}. The weights are relative to one
 * another; if all are 0 every vehicle keeps its lane and its speed.
 *
 * @param overtake weight of a slow vehicle and a fast one that pulls out, passes and comes back;
 *     needs two lanes
 * @param stop weight of a vehicle that brakes, stands and starts again, with or without another
 *     behind it
 */
public record EncounterSettings(
    @Help("Weight of one or two vehicles that keep their lanes and speeds.")
        @Range(min = 0, max = 100)
        @Unit("1")
        double cruise,
    @Help("Weight of a vehicle that overtakes a slower one.") @Range(min = 0, max = 100) @Unit("1")
        double overtake,
    @Help("Weight of a lorry with a motorcycle beside it.") @Range(min = 0, max = 100) @Unit("1")
        double sideBySide,
    @Help("Weight of a vehicle that stops and starts again.") @Range(min = 0, max = 100) @Unit("1")
        double stop,
    @Help("Weight of a vehicle that slows down and speeds up.")
        @Range(min = 0, max = 100)
        @Unit("1")
        double speedChange,
    @Help("Duration of a stop.") @Range(min = 0.1, max = 60) @Unit("s") double stopS) {
  /** Checks the values. */
  public EncounterSettings {
    SettingsSchema.validate(
        EncounterSettings.class, cruise, overtake, sideBySide, stop, speedChange, stopS);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static EncounterSettings defaults() {
    return new EncounterSettings(4, 2, 1, 1, 1, 1.5);
  }
}
