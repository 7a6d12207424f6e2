package haltere.filters.noise;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link RefractoryFilter}.
 *
 * @since 0.1
 */
public record RefractorySettings(
    @Help("An event passes if its pixel was silent for longer than this.")
        @Range(min = 0, max = 10_000_000, logarithmic = true)
        @Unit("us")
        long periodUs,
    @Help("The silence starts at the last event that passed, or at the last event of any kind.")
        Silence silence) {
  /** The event that starts the silence of a pixel. */
  public enum Silence {
    /** The last event that passed: a pixel that fires continuously passes once a period. */
    SINCE_LAST_PASSED,
    /** The last event, passed or not: a pixel that fires continuously never passes. */
    SINCE_LAST_SEEN
  }

  /** Checks the ranges. */
  public RefractorySettings {
    SettingsSchema.validate(RefractorySettings.class, periodUs, silence);
  }

  /**
   * The default settings.
   *
   * @return one millisecond since the last event that passed
   */
  public static RefractorySettings defaults() {
    return new RefractorySettings(1000, Silence.SINCE_LAST_PASSED);
  }
}
