package haltere.filters.noise;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link BackgroundActivityFilter}.
 *
 * @since 0.1
 */
public record BackgroundActivitySettings(
    @Help(
            value =
                "A neighbour supports an event if it fired at most this long before. 0 chooses the"
                    + " time from the measured noise, 1 to 500 ms.",
            label = "Correlation time")
        @Range(min = 0, max = BackgroundActivitySettings.MAX_CORRELATION_US, logarithmic = true)
        @Unit("us")
        int correlationUs,
    @Help("An event passes if at least this many of its eight neighbours support it.")
        @Range(min = 1, max = 8)
        @Unit("pixels")
        int neighbours,
    @Help("Only neighbours that fired with the polarity of the event support it.")
        boolean samePolarity) {
  /** Longest correlation time. */
  static final int MAX_CORRELATION_US = 10_000_000;

  /** Checks the ranges. */
  public BackgroundActivitySettings {
    SettingsSchema.validate(
        BackgroundActivitySettings.class, correlationUs, neighbours, samePolarity);
  }

  /**
   * The default settings.
   *
   * @return automatic time, one neighbour of any polarity
   */
  public static BackgroundActivitySettings defaults() {
    return new BackgroundActivitySettings(0, 1, false);
  }

  /** Whether the correlation time is chosen from the measured noise. */
  boolean isAutomatic() {
    return correlationUs == 0;
  }
}
