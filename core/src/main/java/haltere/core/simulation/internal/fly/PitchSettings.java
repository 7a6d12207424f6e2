package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How the wings pitch about their long axes. In mid stroke the leading edge is in front; at each
 * reversal the wing flips over.
 */
public record PitchSettings(
    @Help(
            "Angle between chord and stroke plane towards the tail; at 0 the whole chord "
                + "is visible.")
        @Range(min = 0, max = 1.5)
        @Unit("rad")
        double towardsTailRad,
    @Help(
            "Angle between chord and stroke plane towards the head; at 0 the whole chord "
                + "is visible.")
        @Range(min = 0, max = 1.5)
        @Unit("rad")
        double towardsHeadRad,
    @Help("Length of the flip at a reversal, as a share of the beat.")
        @Range(min = 0.02, max = 0.45)
        @Unit("1")
        double flipShare,
    @Help("Phase of the middle of a flip before the reversal; negative is delayed.")
        @Range(min = -1, max = 1)
        @Unit("rad")
        double flipAdvanceRad) {
  /** Checks the values. */
  public PitchSettings {
    SettingsSchema.validate(
        PitchSettings.class, towardsTailRad, towardsHeadRad, flipShare, flipAdvanceRad);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static PitchSettings defaults() {
    return new PitchSettings(0.8, 0.8, 0.25, 0.1);
  }
}
