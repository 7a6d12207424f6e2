package haltere.core.simulation.internal.sensor;

import haltere.core.settings.SettingsSchema;
import java.util.Objects;

/**
 * The settings of a simulated sensor that can change while it runs.
 *
 * @param pixel its pixels
 * @param noise background noise
 * @param balance balance of the polarities, -1 to 1: at 1 the threshold for ON is halved and that
 *     for OFF doubled, at 0 they are equal
 */
public record SensorTuning(PixelSettings pixel, NoiseSettings noise, double balance) {
  /** Checks the values. */
  public SensorTuning {
    Objects.requireNonNull(pixel, "pixel");
    Objects.requireNonNull(noise, "noise");
    if (!(balance >= -1 && balance <= 1)) {
      throw new IllegalArgumentException("balance must be -1 to 1, not " + balance);
    }
  }

  /**
   * This tuning with pixel settings changed by name.
   *
   * @param name of a component of {@link PixelSettings} or {@link NoiseSettings}
   * @param value within its range
   * @return a new tuning
   * @throws haltere.core.settings.SettingsProblem if there is none of that name, or the value is
   *     out of range
   */
  public SensorTuning with(String name, double value) {
    SettingsSchema<NoiseSettings> noises = SettingsSchema.of(NoiseSettings.class);
    if (noises.parameters().stream().anyMatch(parameter -> parameter.name().equals(name))) {
      return new SensorTuning(pixel, noises.with(noise, name, value), balance);
    }
    SettingsSchema<PixelSettings> pixels = SettingsSchema.of(PixelSettings.class);
    return new SensorTuning(pixels.with(pixel, name, value), noise, balance);
  }
}
