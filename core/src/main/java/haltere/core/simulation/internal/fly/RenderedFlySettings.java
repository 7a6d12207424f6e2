package haltere.core.simulation.internal.fly;

import haltere.core.settings.SettingsSchema;

/**
 * The fly of a {@link RenderedFlyScene}.
 *
 * @param body its body
 * @param wing outline and transmission of its wings
 * @param pitch how they pitch
 * @param manoeuvres its manoeuvres
 */
public record RenderedFlySettings(
    BodySettings body, MembraneSettings wing, PitchSettings pitch, ManoeuvreSettings manoeuvres) {
  /** Checks the values. */
  public RenderedFlySettings {
    SettingsSchema.validate(RenderedFlySettings.class, body, wing, pitch, manoeuvres);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RenderedFlySettings defaults() {
    return new RenderedFlySettings(
        SettingsSchema.of(BodySettings.class).with(BodySettings.defaults(), "contrast", 3.0),
        MembraneSettings.defaults(),
        PitchSettings.defaults(),
        ManoeuvreSettings.defaults());
  }
}
