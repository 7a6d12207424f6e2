package haltere.core.simulation.internal.fly;

import haltere.core.settings.SettingsSchema;

/**
 * Disturbances for trackers.
 *
 * @param manoeuvres of the fly
 * @param wire in the picture
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
