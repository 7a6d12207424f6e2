package com.example.decimate;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link DecimateFilter}.
 */
public record DecimateSettings(
    @Range(min = 1, max = 1000) @Unit("events") @Help("Interval of passed events; 1 passes all.")
        int keepEvery) {
  /** Checks the values. */
  public DecimateSettings {
    SettingsSchema.validate(DecimateSettings.class, keepEvery);
  }

  /**
   * The default settings.
   *
   * @return settings that pass every second event
   */
  public static DecimateSettings defaults() {
    return new DecimateSettings(2);
  }
}
