package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The two wings as the sensor sees them: dark sectors about their hinges.
 *
 * @param contrast darkness of the wing against the background, natural logarithm of the light,
 *     median over its veins and folds
 * @param contrastSpread spread of the contrast from pixel to pixel and pass to pass, standard
 *     deviation of its logarithm (veins, folds, angle of attack)
 * @param visibleShare share of the wing that casts a shadow at all in one pass; the rest is clear
 *     as glass
 */
public record WingSettings(
    @Help("Length of a wing from hinge to tip.")
        @Range(min = 10, max = 1000, logarithmic = true)
        @Unit("px")
        double lengthPx,
    @Help(
            "Start of the visible wing, as a share of its length; the 6 pixels next to "
                + "the hinge are never visible.")
        @Range(min = 0, max = 0.9)
        @Unit("1")
        double rootShare,
    @Help("Width of the wing as seen from its hinge.")
        @Range(min = 0.005, max = 0.5, logarithmic = true)
        @Unit("rad")
        double widthRad,
    @Help(
            "Contrast of the dark wing to its background, as the natural logarithm of "
                + "the light (median).")
        @Range(min = 0, max = 3)
        @Unit("ln")
        double contrast,
    @Help(
            "Spread of the contrast over the wing and from pass to pass (veins, folds, angle of attack), as the standard deviation of its logarithm.")
        @Range(min = 0, max = 2)
        @Unit("1")
        double contrastSpread,
    @Help(
            "Share of the wing that casts a shadow in one pass, the rest is clear; a "
                + "smaller value thins the events evenly.")
        @Range(min = 0, max = 1)
        @Unit("1")
        double visibleShare) {
  /** Checks the values. */
  public WingSettings {
    SettingsSchema.validate(
        WingSettings.class, lengthPx, rootShare, widthRad, contrast, contrastSpread, visibleShare);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static WingSettings defaults() {
    return new WingSettings(46, 0.3, 0.06, 0.55, 0.5, 0.18);
  }
}
