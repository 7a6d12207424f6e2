package haltere.core.simulation.internal.sensor;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Background noise: events without a change of light.
 *
 * @param leakSpreadDecades spread of the leak over pixels, standard deviation of its decadic
 *     logarithm
 */
public record NoiseSettings(
    @Help("Rate of leak events (ON) of a pixel, mean over the pixels.")
        @Range(min = 0, max = 10)
        @Unit("Hz")
        double leakHz,
    @Help("Spread of the leak over the pixels, as the standard deviation of its decadic logarithm.")
        @Range(min = 0, max = 1)
        @Unit("decades")
        double leakSpreadDecades,
    @Help("Rate of shot noise events of a pixel, both polarities together.")
        @Range(min = 0, max = 50)
        @Unit("Hz")
        double shotHz,
    @Help("Number of hot pixels.") @Range(min = 0, max = 1000) @Unit("pixels") int hotPixels,
    @Help("Rate of ON events of a hot pixel.")
        @Range(min = 0, max = 10000, logarithmic = true)
        @Unit("Hz")
        double hotRateHz) {
  /** Checks the values. */
  public NoiseSettings {
    SettingsSchema.validate(
        NoiseSettings.class, leakHz, leakSpreadDecades, shotHz, hotPixels, hotRateHz);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static NoiseSettings defaults() {
    return new NoiseSettings(0.1, 0.1, 0.5, 3, 200);
  }
}
