package haltere.filters.selection;

import haltere.core.settings.Help;
import haltere.core.settings.SettingsSchema;

/**
 * Settings of {@link PolarityFilter}.
 *
 * @since 0.1
 */
public record PolaritySettings(
    @Help(value = "All events pass, only ON (brighter) or only OFF (darker).", label = "Polarity")
        Keep keep) {
  /** Which events pass. */
  public enum Keep {
    /** Events of both polarities. */
    BOTH,
    /** ON events: brighter. */
    ON,
    /** OFF events: darker. */
    OFF
  }

  /** Checks that the choice is not null. */
  public PolaritySettings {
    SettingsSchema.validate(PolaritySettings.class, keep);
  }

  /**
   * The default settings.
   *
   * @return both polarities
   */
  public static PolaritySettings defaults() {
    return new PolaritySettings(Keep.BOTH);
  }
}
