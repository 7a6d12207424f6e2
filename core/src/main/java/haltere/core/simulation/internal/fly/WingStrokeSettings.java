package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The stroke of one wing. Angles from the heading, 0 at the head, pi at the tail. */
public record WingStrokeSettings(
    @Help("Mean stroke amplitude, half of peak to peak.") @Range(min = 0, max = 1.5) @Unit("rad")
        double amplitudeRad,
    @Help("Mean stroke angle over the cycle, 0 at the head.")
        @Range(min = 0.5, max = 2.6)
        @Unit("rad")
        double centreRad,
    @Help("Phase lag of the wing behind the common beat.")
        @Range(min = -3.141592653589793, max = 3.141592653589793)
        @Unit("rad")
        double phaseLagRad,
    @Help("Frequency of the wing above that of the common beat.")
        @Range(min = -50, max = 50)
        @Unit("Hz")
        double frequencyOffsetHz) {
  /** Checks the values. */
  public WingStrokeSettings {
    SettingsSchema.validate(
        WingStrokeSettings.class, amplitudeRad, centreRad, phaseLagRad, frequencyOffsetHz);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static WingStrokeSettings defaults() {
    return new WingStrokeSettings(1.15, 1.72, 0, 0);
  }
}
