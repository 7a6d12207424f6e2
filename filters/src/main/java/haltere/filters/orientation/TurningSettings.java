package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How the axis turns: at rates that decay and are driven by noise, calmly or in saccades.
 *
 * @param calmRateRadS standard deviation of a rate in calm flight
 * @param saccadeRateRadS standard deviation of a rate in a saccade
 * @param decayS time constant of the rates
 * @param saccadesPerS how often a saccade begins
 * @param saccadeS how long it lasts
 * @param updateNoise variance that the source adds at each update
 */
public record TurningSettings(
    @Help("Standard deviation of the rate of turning about one axis, in calm flight.")
        @Range(min = 0.001, max = 1000, logarithmic = true)
        @Unit("rad/s")
        double calmRateRadS,
    @Help(
            "Standard deviation of the rate in a saccade; as large as the calm one for a body that"
                + " makes none.")
        @Range(min = 0.001, max = 1000, logarithmic = true)
        @Unit("rad/s")
        double saccadeRateRadS,
    @Help("Time constant with which rates decay.")
        @Range(min = 0.001, max = 1000, logarithmic = true)
        @Unit("s")
        double decayS,
    @Help("How often a saccade begins.")
        @Range(min = 0.001, max = 100, logarithmic = true)
        @Unit("Hz")
        double saccadesPerS,
    @Help("How long a saccade lasts on average.")
        @Range(min = 0.001, max = 100, logarithmic = true)
        @Unit("s")
        double saccadeS,
    @Help(
            "Quaternions only: a variance that is added to each of the seven states at every"
                + " update, as the source does, instead of what the rates say; 0 for none.")
        @Range(min = 0, max = 1000)
        @Unit("1")
        double updateNoise) {
  /** Checks the ranges. */
  public TurningSettings {
    SettingsSchema.validate(
        TurningSettings.class,
        calmRateRadS,
        saccadeRateRadS,
        decayS,
        saccadesPerS,
        saccadeS,
        updateNoise);
  }

  /** Share of the time that is spent in saccades. */
  double saccadeShare() {
    return saccadesPerS * saccadeS / (1 + saccadesPerS * saccadeS);
  }

  /** Variance of a rate, over calm flight and saccades. */
  double meanRateVariance() {
    double share = saccadeShare();
    return (1 - share) * calmRateRadS * calmRateRadS + share * saccadeRateRadS * saccadeRateRadS;
  }

  /**
   * The settings to start from.
   *
   * @return a fly: calm with a saccade now and then
   */
  public static TurningSettings defaults() {
    return new TurningSettings(1, 40, 0.5, 0.3, 0.05, 0);
  }
}
