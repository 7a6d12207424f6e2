package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings that both wings share.
 *
 * @param clapAndFling whether the wings nearly meet behind the body at each upstroke; sets both
 *     centres
 * @param harmonics second and third harmonic of the free waveform
 */
public record BeatSettings(
    @Help("Stroke angle over the cycle, as published fits give it.") StrokeWaveform waveform,
    @Help("Mean wing beat frequency.") @Range(min = 1, max = 1000, logarithmic = true) @Unit("Hz")
        double frequencyHz,
    @Help("Standard deviation of the frequency over time.") @Range(min = 0, max = 50) @Unit("Hz")
        double frequencySdHz,
    @Help("Standard deviation of the stroke amplitude over time.")
        @Range(min = 0, max = 0.3)
        @Unit("rad")
        double amplitudeSdRad,
    @Help("Period of the fastest part of the slow changes of frequency and amplitude.")
        @Range(min = 0.1, max = 100, logarithmic = true)
        @Unit("s")
        double timescaleS,
    @Help("Whether the wings nearly meet behind the body at the top of each upstroke.")
        boolean clapAndFling,
    HarmonicSettings harmonics) {
  /** Checks the values. */
  public BeatSettings {
    SettingsSchema.validate(
        BeatSettings.class,
        waveform,
        frequencyHz,
        frequencySdHz,
        amplitudeSdRad,
        timescaleS,
        clapAndFling,
        harmonics);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static BeatSettings defaults() {
    return new BeatSettings(
        StrokeWaveform.MUIJRES, 200, 4.8, 0.047, 1, false, HarmonicSettings.defaults());
  }
}
