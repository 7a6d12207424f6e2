package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.SettingsSchema;

/**
 * Which tracks are of one thing, and which are of none.
 *
 * @param together whether tracks that stay side by side are one thing, of which one is shown
 * @param standing whether places that make events and never move are shown
 */
public record ThingSettings(
    @Help("Tracks that begin beside another, or stay beside it, are parts of it and not shown.")
        boolean together,
    @Help("Shows tracks that have never moved as well: lamps that flicker, say.")
        boolean standing) {
  /** Checks the ranges. */
  public ThingSettings {
    SettingsSchema.validate(ThingSettings.class, together, standing);
  }

  /**
   * The settings to start from.
   *
   * @return a thing is shown once, what never moves is not
   */
  public static ThingSettings defaults() {
    return new ThingSettings(true, false);
  }
}
