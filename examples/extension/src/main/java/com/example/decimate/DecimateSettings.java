package com.example.decimate;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link DecimateFilter}.
 */
public record DecimateSettings(
    @Range(min = 1, max = 1000) @Unit("events") @Help("One of so many events is kept; 1 keeps all.")
        int keepEvery) {
  /** Checks the values. */
  public DecimateSettings {
    SettingsSchema.validate(DecimateSettings.class, keepEvery);
  }

  /**
   * What the filter starts with.
   *
   * @return every second event
   */
  public static DecimateSettings defaults() {
    return new DecimateSettings(2);
  }
}
