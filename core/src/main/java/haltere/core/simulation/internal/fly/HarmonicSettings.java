package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Harmonics of the free waveform, relative to the first: sin p + second sin(2 p + secondPhaseRad) +
 * third sin(3 p + thirdPhaseRad).
 */
public record HarmonicSettings(
    @Help("Second harmonic of the free waveform, as a share of the first.")
        @Range(min = 0, max = 0.3)
        @Unit("1")
        double second,
    @Help("Phase of the second harmonic of the free waveform.")
        @Range(min = -6.283185307179586, max = 6.283185307179586)
        @Unit("rad")
        double secondPhaseRad,
    @Help("Third harmonic of the free waveform, as a share of the first.")
        @Range(min = 0, max = 0.1)
        @Unit("1")
        double third,
    @Help("Phase of the third harmonic of the free waveform.")
        @Range(min = -6.283185307179586, max = 6.283185307179586)
        @Unit("rad")
        double thirdPhaseRad) {
  /** Checks the values. */
  public HarmonicSettings {
    SettingsSchema.validate(HarmonicSettings.class, second, secondPhaseRad, third, thirdPhaseRad);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static HarmonicSettings defaults() {
    return new HarmonicSettings(0.1, 0.8, 0.02, 0);
  }
}
