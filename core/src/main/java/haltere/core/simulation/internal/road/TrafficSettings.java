package haltere.core.simulation.internal.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The traffic of {@link RoadScene}. It drives on the right: away from the bridge on the right of
 * the picture, towards it on the left.
 *
 * @param pauseS mean pause between two groups of vehicles of one direction, seconds; they keep
 *     their distance, so it is longer where they have to wait
 * @param encounters the behaviour of the groups
 */
public record TrafficSettings(
    @Help("Number of lanes away from the camera, on the right of the picture.")
        @Range(min = 0, max = 4)
        @Unit("lanes")
        int lanesAway,
    @Help("Number of lanes towards the camera, on the left of the picture.")
        @Range(min = 0, max = 4)
        @Unit("lanes")
        int lanesTowards,
    @Help("Width of a lane.") @Range(min = 2.5, max = 6) @Unit("m") double laneWidthM,
    @Help("Distance up to which vehicles are visible.")
        @Range(min = 30, max = 400, logarithmic = true)
        @Unit("m")
        double roadM,
    @Help("Mean speed of the vehicles.") @Range(min = 3, max = 100, logarithmic = true) @Unit("m/s")
        double speedMS,
    @Help("Standard deviation of the speed over the vehicles, as a share of the mean.")
        @Range(min = 0, max = 0.3)
        @Unit("1")
        double speedSpread,
    @Help("Mean pause between two groups of vehicles of one direction.")
        @Range(min = 0.1, max = 1000, logarithmic = true)
        @Unit("s")
        double pauseS,
    EncounterSettings encounters) {
  /** Checks the values. */
  public TrafficSettings {
    SettingsSchema.validate(
        TrafficSettings.class,
        lanesAway,
        lanesTowards,
        laneWidthM,
        roadM,
        speedMS,
        speedSpread,
        pauseS,
        encounters);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static TrafficSettings defaults() {
    return new TrafficSettings(2, 2, 3.5, 110, 16, 0.08, 1, EncounterSettings.defaults());
  }
}
