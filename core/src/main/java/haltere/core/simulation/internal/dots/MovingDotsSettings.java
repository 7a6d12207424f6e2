package haltere.core.simulation.internal.dots;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The moving dots of {@link MovingDotsScene}.
 *
 * @param sensor the sensor
 * @param dots the dots
 * @param noise background noise
 * @param run seed, start and length
 */
public record MovingDotsSettings(
    SensorSettings sensor, DotSettings dots, NoiseSettings noise, RunSettings run)
    implements AdjustableSettings<MovingDotsSettings> {
  /** Checks the values. */
  public MovingDotsSettings {
    SettingsSchema.validate(MovingDotsSettings.class, sensor, dots, noise, run);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static MovingDotsSettings defaults() {
    return new MovingDotsSettings(
        SensorSettings.defaults(),
        DotSettings.defaults(),
        NoiseSettings.defaults(),
        new RunSettings(1, 0, 0, 100));
  }
}
