package haltere.core.simulation.internal.fly;

import haltere.core.settings.SettingsSchema;

/**
 * What makes a tracker's life hard.
 *
 * @param manoeuvres what the fly does
 * @param wire what is in the way
 */
public record DisturbanceSettings(ManoeuvreSettings manoeuvres, WireSettings wire) {
  /** Checks the values. */
  public DisturbanceSettings {
    SettingsSchema.validate(DisturbanceSettings.class, manoeuvres, wire);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static DisturbanceSettings defaults() {
    return new DisturbanceSettings(ManoeuvreSettings.defaults(), WireSettings.defaults());
  }
}
