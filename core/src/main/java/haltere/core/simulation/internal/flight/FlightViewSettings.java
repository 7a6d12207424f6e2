package haltere.core.simulation.internal.flight;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The cameras of {@link FlightScene}: in a ring around the flight volume, all directed at its
 * centre.
 */
public record FlightViewSettings(
    @Help("Number of cameras.") @Range(min = 1, max = 16) @Unit("cameras") int cameras,
    @Help("Camera whose events are simulated, from 0 on.") @Range(min = 0, max = 15) @Unit("1")
        int camera,
    @Help("Distance of the cameras from the middle.")
        @Range(min = 0.05, max = 100, logarithmic = true)
        @Unit("m")
        double distanceM,
    @Help("Radius of the room in which the body flies and that the cameras see.")
        @Range(min = 0.01, max = 10, logarithmic = true)
        @Unit("m")
        double roomM) {
  /** Checks the ranges. */
  public FlightViewSettings {
    SettingsSchema.validate(FlightViewSettings.class, cameras, camera, distanceM, roomM);
  }

  /**
   * The default settings.
   *
   * @return three cameras, 0.6 m away
   */
  public static FlightViewSettings defaults() {
    return new FlightViewSettings(3, 0, 0.6, 0.15);
  }
}
