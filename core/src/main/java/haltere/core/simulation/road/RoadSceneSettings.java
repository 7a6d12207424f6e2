package haltere.core.simulation.road;

import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.NoiseSettings;
import haltere.core.simulation.PixelSettings;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.SensorSettings;

/**
 * The road of {@link RoadScene}. The defaults show two lanes each way in lively traffic.
 *
 * @param sensor the sensor
 * @param camera the camera on the bridge
 * @param traffic lanes, speeds and what the vehicles do
 * @param vehicles the vehicles
 * @param pixel the pixels of the sensor
 * @param noise events without a cause
 * @param rain rain before the camera
 * @param run seed, start and length
 */
public record RoadSceneSettings(
    SensorSettings sensor,
    RoadCameraSettings camera,
    TrafficSettings traffic,
    VehicleSettings vehicles,
    PixelSettings pixel,
    NoiseSettings noise,
    RainSettings rain,
    RunSettings run) {
  /** Checks the values. */
  public RoadSceneSettings {
    SettingsSchema.validate(
        RoadSceneSettings.class, sensor, camera, traffic, vehicles, pixel, noise, rain, run);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RoadSceneSettings defaults() {
    return new RoadSceneSettings(
        SensorSettings.defaults(),
        RoadCameraSettings.defaults(),
        TrafficSettings.defaults(),
        VehicleSettings.defaults(),
        PixelSettings.defaults(),
        NoiseSettings.defaults(),
        RainSettings.defaults(),
        new RunSettings(1, 0, 0, 100));
  }

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code run.seed=7}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public RoadSceneSettings with(String... assignments) {
    return SettingsSchema.of(RoadSceneSettings.class)
        .withAssignments(this, java.util.List.of(assignments));
  }
}
