package haltere.filters.noise;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link HotPixelsFilter}.
 *
 * @since 0.1
 */
public record HotPixelsSettings(
    @Help("Hot pixels are detected again after each period of this length.")
        @Range(min = 1000, max = 60_000_000, logarithmic = true)
        @Unit("us")
        long periodUs,
    @Help("A pixel is hot only if its event rate is higher than this.")
        @Range(min = 0.1, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help(
            "A pixel is hot only if its event rate is higher than this multiple of its "
                + "neighbours' mean rate.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("1")
        double ratio,
    @Help(
            "A blocked pixel is released after this many consecutive periods in which it "
                + "was not hot.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("periods")
        int calmPeriods,
    @Help("Largest number of blocked pixels, the busiest first.")
        @Range(min = 0, max = 100_000, logarithmic = true)
        @Unit("pixels")
        int mostBlocked) {
  /** Checks the ranges. */
  public HotPixelsSettings {
    SettingsSchema.validate(
        HotPixelsSettings.class, periodUs, rateHz, ratio, calmPeriods, mostBlocked);
  }

  /**
   * The settings to start from.
   *
   * @return half a second, 50 Hz, six times the neighbours, four periods, 1000 pixels
   */
  public static HotPixelsSettings defaults() {
    return new HotPixelsSettings(500_000, 50, 6, 4, 1000);
  }
}
