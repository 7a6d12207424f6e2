package haltere.core.simulation.internal.road;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The road of {@link RoadScene}. The defaults show two lanes each way in lively traffic.
 *
 * @param sensor the sensor
 * @param camera the camera on the bridge
 * @param traffic lanes, speeds and behaviour of the vehicles
 * @param vehicles the vehicles
 * @param pixel the pixels of the sensor
 * @param noise background noise
 * @param rain rain in front of the camera
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
    RunSettings run)
    implements AdjustableSettings<RoadSceneSettings> {
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
}
