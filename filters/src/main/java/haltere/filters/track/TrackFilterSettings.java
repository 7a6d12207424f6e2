package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Variances of the Kalman filters of tracks.
 *
 * @param minProcessVariance process noise in the picture: as a density px²/s³; per update px² for
 *     positions and px²/s² for velocities
 * @param varianceMixingFactor share of the difference to the final value, per update
 */
public record TrackFilterSettings(
    @Help("Process noise: a spectral density, or a constant variance per update.") Noise noise,
    @Help("Process noise; a larger value follows manoeuvres faster. Per update, the unit is px^2.")
        @Range(min = 0, max = 1e9, logarithmic = true)
        @Unit("px^2/s^3")
        double minProcessVariance,
    @Help("Variance of the location of a cluster; a larger value smooths more.")
        @Range(min = 1e-4, max = 1e6, logarithmic = true)
        @Unit("px^2")
        double maxMeasurementVariance,
    @Help("A young track has a smaller measurement variance and a larger process variance.")
        boolean dynamicVariances,
    @Help(
            "Share of the difference to its final value by which a dynamic variance changes per update.")
        @Range(min = 1e-4, max = 1, logarithmic = true)
        @Unit("1")
        double varianceMixingFactor,
    @Help("Standard deviation of the unknown velocity of a new track.")
        @Range(min = 1, max = 1e5, logarithmic = true)
        @Unit("px/s")
        double launchSpeedPxS) {
  /** Growth of the process noise. */
  public enum Noise {
    /** White acceleration of a density per second, integrated over each step. */
    DENSITY,
    /** The same variance of each state at each update, independent of the step. */
    PER_UPDATE
  }

  /** Checks the ranges. */
  public TrackFilterSettings {
    SettingsSchema.validate(
        TrackFilterSettings.class,
        noise,
        minProcessVariance,
        maxMeasurementVariance,
        dynamicVariances,
        varianceMixingFactor,
        launchSpeedPxS);
  }

  /**
   * {@return the default settings: constant variances: a density of 20,000 px²/s³, 1 px², 300 px/s
   * at launch}
   */
  public static TrackFilterSettings defaults() {
    return new TrackFilterSettings(Noise.DENSITY, 20_000, 1, false, 0.01, 300);
  }
}
