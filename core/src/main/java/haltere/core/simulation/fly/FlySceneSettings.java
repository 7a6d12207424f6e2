package haltere.core.simulation.fly;

import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.NoiseSettings;
import haltere.core.simulation.PixelSettings;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.SensorSettings;

/**
 * The tethered fly of {@link FlyScene}. The defaults show a fly in steady flight with now and then
 * a manoeuvre.
 *
 * @param sensor the sensor
 * @param fly the fly
 * @param stroke how its wings beat
 * @param pixel the pixels of the sensor
 * @param noise events without a cause
 * @param disturbances what makes tracking hard
 * @param run seed, start and length
 */
public record FlySceneSettings(
    SensorSettings sensor,
    FlySettings fly,
    StrokeSettings stroke,
    PixelSettings pixel,
    NoiseSettings noise,
    DisturbanceSettings disturbances,
    RunSettings run) {
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

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code run.seed=7}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public FlySceneSettings with(String... assignments) {
    return SettingsSchema.of(FlySceneSettings.class)
        .withAssignments(this, java.util.List.of(assignments));
  }
}
