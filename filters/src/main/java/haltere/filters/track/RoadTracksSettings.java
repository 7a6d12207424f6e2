package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Tracks on a road, in metres, and what is counted there.
 *
 * @param mapToRoad whether tracks are on a road
 * @param view how the camera sees the road
 * @param processVariance process noise of a vehicle that keeps its speed and lane
 * @param lanes the lanes
 * @param countingLines the lines at which vehicles are counted
 */
public record RoadTracksSettings(
    @Help("Tracks live on the road, in metres, instead of in the picture.") boolean mapToRoad,
    RoadSettings view,
    @Help("Process noise of a vehicle that keeps its speed; steering has 300 times as much.")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("m^2/s^3")
        double processVariance,
    LaneSettings lanes,
    CountingLineSettings countingLines) {
  /** Checks the ranges. */
  public RoadTracksSettings {
    SettingsSchema.validate(
        RoadTracksSettings.class, mapToRoad, view, processVariance, lanes, countingLines);
  }

  /**
   * The settings to start from.
   *
   * @return not on a road
   */
  public static RoadTracksSettings defaults() {
    return new RoadTracksSettings(
        false,
        RoadSettings.defaults(),
        0.02,
        LaneSettings.defaults(),
        CountingLineSettings.defaults());
  }

  /**
   * Tracks on the road that a camera sees.
   *
   * @param newView how it sees it
   * @return these settings with the mapping on
   */
  public RoadTracksSettings seenAs(RoadSettings newView) {
    return new RoadTracksSettings(true, newView, processVariance, lanes, countingLines);
  }
}
