package haltere.core.simulation.internal.fly;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The tethered fly of {@link FlyScene}. The defaults show a fly in steady flight with occasional
 * manoeuvres.
 *
 * @param sensor the sensor
 * @param fly the fly
 * @param stroke how its wings beat
 * @param pixel the pixels of the sensor
 * @param noise background noise
 * @param disturbances disturbances for trackers
 * @param run seed, start and length
 */
public record FlySceneSettings(
    SensorSettings sensor,
    FlySettings fly,
    StrokeSettings stroke,
    PixelSettings pixel,
    NoiseSettings noise,
    DisturbanceSettings disturbances,
    RunSettings run)
    implements AdjustableSettings<FlySceneSettings> {
  /** Checks the values. */
  public FlySceneSettings {
    SettingsSchema.validate(
        FlySceneSettings.class, sensor, fly, stroke, pixel, noise, disturbances, run);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static FlySceneSettings defaults() {
    return new FlySceneSettings(
        SensorSettings.defaults(),
        FlySettings.defaults(),
        StrokeSettings.defaults(),
        PixelSettings.defaults(),
        NoiseSettings.defaults(),
        DisturbanceSettings.defaults(),
        RunSettings.defaults());
  }
}
