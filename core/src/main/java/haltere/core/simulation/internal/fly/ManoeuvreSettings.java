package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Manoeuvres at seeded times: in turn a step of the frequency, a step of the amplitudes against
 * each other, a saccade.
 *
 * @param everyS mean time between manoeuvres, seconds, 0 for none; at least the hold and 16 time
 *     constants
 * @param turnRad turn of the heading in a saccade of 80 ms, to and fro in turn; a rigid tether has
 *     0
 */
public record ManoeuvreSettings(
    @Help(
            "Mean time between manoeuvres, 0 for none; never shorter than one hold and 16 time constants.")
        @Range(min = 0, max = 1000)
        @Unit("s")
        double everyS,
    @Help("Height of the step of the frequency.") @Range(min = -50, max = 50) @Unit("Hz")
        double frequencyStepHz,
    @Help("Amplitude of one wing over that of the other in a step of the amplitudes.")
        @Range(min = 0, max = 0.5)
        @Unit("rad")
        double asymmetryRad,
    @Help("Turn of the heading in a saccade of 80 ms, left and right in turn; 0 on a rigid tether.")
        @Range(min = 0, max = 3.2)
        @Unit("rad")
        double turnRad,
    @Help("Time constant of the steps.")
        @Range(min = 0.005, max = 0.1, logarithmic = true)
        @Unit("s")
        double timeConstantS,
    @Help("Duration of a step.") @Range(min = 0.05, max = 2, logarithmic = true) @Unit("s")
        double holdS) {
  /** Checks the values. */
  public ManoeuvreSettings {
    SettingsSchema.validate(
        ManoeuvreSettings.class,
        everyS,
        frequencyStepHz,
        asymmetryRad,
        turnRad,
        timeConstantS,
        holdS);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static ManoeuvreSettings defaults() {
    return new ManoeuvreSettings(3, 15, 0.14, 0, 0.05, 0.4);
  }
}
