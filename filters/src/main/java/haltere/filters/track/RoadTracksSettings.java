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
    @Help("Tracks have states in metres on the road instead of in pixels.") boolean mapToRoad,
    RoadViewSettings view,
    @Help("Process noise on the road; a larger value follows changes of speed faster.")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("m^2/s^3")
        double processVariance) {
  /** Checks the ranges. */
  public RoadTracksSettings {
    SettingsSchema.validate(RoadTracksSettings.class, mapToRoad, view, processVariance);
  }

  /** {@return the default settings: not on a road; there, a density of 10 m²/s³} */
  public static RoadTracksSettings defaults() {
    return new RoadTracksSettings(false, RoadViewSettings.defaults(), 10);
  }
}
