package haltere.filters.noise;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import java.util.Map;

/**
 * Settings of {@link HotPixelsFilter}.
 *
 * @since 0.1
 */
public record HotPixelsSettings(
    @Help("Hot pixels are determined again after each period of this length.")
        @Range(min = 1000, max = 60_000_000, logarithmic = true)
        @Unit("us")
        long periodUs,
    @Help(
            value = "A pixel may be hot only if it fires at more than this rate.",
            label = "Minimum rate")
        @Range(min = 0.1, max = 10_000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help(
            value =
                "A pixel is hot only if it fires at more than this multiple of its neighbours' mean"
                    + " rate.",
            label = "Rate ratio")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("1")
        double ratio,
    @Help(
            "A blocked pixel passes again after this many consecutive periods in which it was not hot.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("periods")
        int calmPeriods,
    @Help(
            value = "No more pixels than this are blocked at a time, the busiest first.",
            label = "Maximum blocked pixels")
        @Range(min = 0, max = 100_000, logarithmic = true)
        @Unit("pixels")
        int maxBlocked) {
  /** Checks the ranges. */
  public HotPixelsSettings {
    SettingsSchema.validate(
        HotPixelsSettings.class, periodUs, rateHz, ratio, calmPeriods, maxBlocked);
  }

  static Map<String, String> formerNames() {
    return Map.of("mostBlocked", "maxBlocked");
  }

  /**
   * The default settings.
   *
   * @return half a second, 50 Hz, six times the neighbours, four periods, 1000 pixels
   */
  public static HotPixelsSettings defaults() {
    return new HotPixelsSettings(500_000, 50, 6, 4, 1000);
  }
}
