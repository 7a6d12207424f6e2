package haltere.filters.noise;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link BackgroundActivityFilter}.
 *
 * @param correlationUs how long an event supports its neighbours
 * @param neighbours how many of the eight must have fired
 * @param samePolarity whether only neighbours of the event's own polarity count
 */
public record BackgroundActivitySettings(
    @Help("A neighbour supports an event if it fired at most this long before.")
        @Range(min = 1, max = BackgroundActivitySettings.MAX_CORRELATION_US, logarithmic = true)
        @Unit("us")
        int correlationUs,
    @Help("An event passes if at least this many of its eight neighbours support it.")
        @Range(min = 1, max = 8)
        @Unit("pixels")
        int neighbours,
    @Help("Whether only neighbours that fired with the event's own polarity support it.")
        boolean samePolarity) {
  /** The longest time of support. */
  static final int MAX_CORRELATION_US = 10_000_000;

  /** Checks the ranges. */
  public BackgroundActivitySettings {
    SettingsSchema.validate(
        BackgroundActivitySettings.class, correlationUs, neighbours, samePolarity);
  }

  /**
   * The settings to start from: 10 ms and one neighbour. At a background activity of 1 Hz a pixel
   * they pass one noise event in 13, and every edge that moves faster than 100 pixels a second; of
   * a DVS128's recording of a slowly moving box they pass 75 %, where 5 ms pass 58 %.
   *
   * @return 10 ms, one neighbour of any polarity
   */
  public static BackgroundActivitySettings defaults() {
    return new BackgroundActivitySettings(10_000, 1, false);
  }
}
