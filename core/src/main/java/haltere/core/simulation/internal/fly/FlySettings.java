package haltere.core.simulation.internal.fly;

import haltere.core.settings.SettingsSchema;

/**
 * The fly.
 *
 * @param body its body
 * @param wing its wings
 */
public record FlySettings(BodySettings body, WingSettings wing) {
  /** Checks the values. */
  public FlySettings {
    SettingsSchema.validate(FlySettings.class, body, wing);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static FlySettings defaults() {
    return new FlySettings(BodySettings.defaults(), WingSettings.defaults());
  }
}
