package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The wings of a rendered fly: half-transparent membranes with veins. The chord at a share u of the
 * length is proportional to u^root (1 - u)^tip, the beta distribution of Ellington (1984, part II).
 */
public record MembraneSettings(
    @Help("Length of a wing from hinge to tip.")
        @Range(min = 10, max = 500, logarithmic = true)
        @Unit("px")
        double lengthPx,
    @Help("Largest chord of a wing, as a share of its length.")
        @Range(min = 0.02, max = 0.8, logarithmic = true)
        @Unit("1")
        double chordShare,
    @Help("Exponent of the chord's growth from the hinge on: 0.5 is an ellipse, 1.5 a teardrop.")
        @Range(min = 0.1, max = 3)
        @Unit("1")
        double rootExponent,
    @Help(
            "Exponent of the chord's decline towards the tip: 0.5 is an ellipse, 0.1 "
                + "nearly square.")
        @Range(min = 0.1, max = 3)
        @Unit("1")
        double tipExponent,
    @Help("Share of the chord in front of the axis about which a wing pitches: 0 is its edge.")
        @Range(min = 0, max = 0.5)
        @Unit("1")
        double axisShare,
    @Help("Share of the light that passes the membrane of a wing.")
        @Range(min = 0.05, max = 1)
        @Unit("1")
        double transmission,
    @Help("Number of veins along a wing; the first is its leading edge.")
        @Range(min = 0, max = 6)
        @Unit("veins")
        int veins,
    @Help("Share of the light that passes a vein.") @Range(min = 0.05, max = 1) @Unit("1")
        double veinTransmission) {
  /** Checks the values. */
  public MembraneSettings {
    SettingsSchema.validate(
        MembraneSettings.class,
        lengthPx,
        chordShare,
        rootExponent,
        tipExponent,
        axisShare,
        transmission,
        veins,
        veinTransmission);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static MembraneSettings defaults() {
    return new MembraneSettings(46, 0.35, 0.8, 0.4, 0.25, 0.7, 1, 0.4);
  }
}
