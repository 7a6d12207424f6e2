package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The light behind the fly. */
public record LightSettings(
    @Help("Vignetting: share of the light missing in the corners of the picture.")
        @Range(min = 0, max = 0.9)
        @Unit("1")
        double vignetting,
    @Help("Amplitude of the flicker of the light, as a share of it; 0 for none.")
        @Range(min = 0, max = 0.9)
        @Unit("1")
        double flickerShare,
    @Help("Frequency of the flicker of the light.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("Hz")
        double flickerHz) {
  /** Checks the values. */
  public LightSettings {
    SettingsSchema.validate(LightSettings.class, vignetting, flickerShare, flickerHz);
  }

  /**
   * The default settings.
   *
   * @return a steady, even light
   */
  public static LightSettings defaults() {
    return new LightSettings(0, 0, 100);
  }
}
