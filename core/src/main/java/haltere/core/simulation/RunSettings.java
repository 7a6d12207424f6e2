package haltere.core.simulation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import java.util.OptionalLong;

/**
 * The run of a scene.
 *
 * @since 0.1
 */
public record RunSettings(
    @Help("Seed of the random numbers; the same seed gives the same events.")
        @Range(min = -9007199254740991.0, max = 9007199254740991.0)
        @Unit("1")
        long seed,
    @Help("Time stamp of the start of the scene.") @Range(min = 0, max = 4e15) @Unit("us")
        long startUs,
    @Help("Length of the scene, 0 for endless.")
        @Range(min = 0, max = 1000000, logarithmic = true)
        @Unit("s")
        double durationS,
    @Help("Rows of ground truth per second.")
        @Range(min = 0.1, max = 1000000, logarithmic = true)
        @Unit("Hz")
        double truthRateHz) {
  /** Checks the values. */
  public RunSettings {
    SettingsSchema.validate(RunSettings.class, seed, startUs, durationS, truthRateHz);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RunSettings defaults() {
    return new RunSettings(1, 0, 0, 1000);
  }

  /**
   * Length in whole microseconds.
   *
   * @return microseconds, or empty if the scene is endless
   */
  public OptionalLong durationUs() {
    return durationS == 0 ? OptionalLong.empty() : OptionalLong.of(Math.round(durationS * 1e6));
  }
}
