package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.filters.plane.RoadViewSettings;

/**
 * Tracks on a road, in metres.
 *
 * @param view how the camera sees the road
 */
public record RoadTracksSettings(
    @Help("The state of a track is on the road, in metres, instead of in the picture.")
        boolean mapToRoad,
    RoadViewSettings view,
    @Help("Process noise on the road; larger values follow changes of speed faster.")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("m^2/s^3")
        double processVariance) {
  /** Checks the ranges. */
  public RoadTracksSettings {
    SettingsSchema.validate(RoadTracksSettings.class, mapToRoad, view, processVariance);
  }

  /** {@return the settings to start from: not on a road; there, a density of 10 m²/s³} */
  public static RoadTracksSettings defaults() {
    return new RoadTracksSettings(false, RoadViewSettings.defaults(), 10);
  }
}
