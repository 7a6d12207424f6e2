package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Which observations are used.
 *
 * @param angleDeg largest angle between what is seen and what is expected
 * @param minAreaPx smallest area
 * @param minEccentricity smallest ratio of the axes
 * @param outlierShare share of observations that have nothing to do with the body
 */
public record ObservationGateSettings(
    @Help(
            "An observation is used if its line is less than this away from the expected one: 0"
                + " rejects all, those of the start included; 90 and more accept all, whatever the"
                + " outlier share is.")
        @Range(min = 0, max = 180)
        @Unit("deg")
        double angleDeg,
    @Help("A detection must be larger than this; one of unknown area is.")
        @Range(min = 0, max = 1e9)
        @Unit("px^2")
        double minAreaPx,
    @Help(
            "A detection's long axis must be more than this times its short one; one of unknown"
                + " ratio is.")
        @Range(min = 0, max = 1000)
        @Unit("1")
        double minEccentricity,
    @Help(
            "Share of lines that are not the body's; one that is more likely such a line is not"
                + " used. 0 leaves it all to the angle.")
        @Range(min = 0, max = 0.5)
        @Unit("1")
        double outlierShare) {
  /** Checks the ranges. */
  public ObservationGateSettings {
    SettingsSchema.validate(
        ObservationGateSettings.class, angleDeg, minAreaPx, minEccentricity, outlierShare);
  }

  /** The outlier share, 0 where the angle accepts all. */
  double effectiveOutlierShare() {
    return angleDeg >= 90 ? 0 : outlierShare;
  }

  /**
   * The settings to start from.
   *
   * @return the source's 40 degrees, any area and ratio, one outlier in ten
   */
  public static ObservationGateSettings defaults() {
    return new ObservationGateSettings(40, 0, 0, 0.1);
  }
}
