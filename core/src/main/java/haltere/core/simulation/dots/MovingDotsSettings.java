package haltere.core.simulation.dots;

import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.NoiseSettings;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.SensorSettings;

/**
 * The moving dots of {@link MovingDotsScene}.
 *
 * @param sensor the sensor
 * @param dots the dots
 * @param noise events without a cause
 * @param run seed, start and length
 */
public record MovingDotsSettings(
    SensorSettings sensor, DotSettings dots, NoiseSettings noise, RunSettings run) {
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

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code run.seed=7}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public MovingDotsSettings with(String... assignments) {
    return SettingsSchema.of(MovingDotsSettings.class)
        .withAssignments(this, java.util.List.of(assignments));
  }
}
