package haltere.filters.frequency;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link FrequencyMap}.
 *
 * @since 0.1
 */
public record FrequencyMapSettings(
    @Help("A lower value finds slower flicker and keeps a frequency for longer.")
        @Range(min = 0.1, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double minFrequencyHz,
    @Help("A higher value finds faster flicker and lets more noise through.")
        @Range(min = 1, max = 50_000, logarithmic = true)
        @Unit("Hz")
        double maxFrequencyHz,
    @Help("A larger value accepts less regular flicker.")
        @Range(min = 0.01, max = 0.5, logarithmic = true)
        @Unit("1")
        double tolerance,
    @Help("A larger value publishes the frequencies of all pixels more often.")
        @Range(min = 0.01, max = 1000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz) {
  /** Checks the ranges. */
  public FrequencyMapSettings {
    SettingsSchema.validate(
        FrequencyMapSettings.class, minFrequencyHz, maxFrequencyHz, tolerance, reportRateHz);
  }

  /**
   * The default settings.
   *
   * @return 5 Hz to 1 kHz, periods equal within a twentieth, one report a second
   */
  public static FrequencyMapSettings defaults() {
    return new FrequencyMapSettings(5, 1000, 0.05, 1);
  }
}
