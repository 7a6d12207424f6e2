package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** Position and motion of the fly's body. The body centre is the midpoint of the two hinges. */
public record BodySettings(
    @Help("Mean position of the body centre, to the right of the middle of the sensor.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double offsetXPx,
    @Help("Mean position of the body centre, above the middle of the sensor.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double offsetYPx,
    @Help("Direction of the body from tail to head, counterclockwise from the x axis.")
        @Range(min = 0, max = 6.283185307179586)
        @Unit("rad")
        double headingRad,
    @Help("Length of the body from the head to the tip of the abdomen.")
        @Range(min = 5, max = 1000, logarithmic = true)
        @Unit("px")
        double lengthPx,
    @Help("Distance of each wing hinge from the body axis.") @Range(min = 0, max = 6) @Unit("px")
        double hingeOffsetPx,
    @Help("Standard deviation of the fast wobble of the body, 1 to 8 Hz, along each axis.")
        @Range(min = 0, max = 5)
        @Unit("px")
        double wobblePx,
    @Help("Standard deviation of the slow drift of the body, 0.02 to 0.2 Hz, along each axis.")
        @Range(min = 0, max = 20)
        @Unit("px")
        double driftPx,
    @Help("Contrast of the dark body to its background, as the natural logarithm of the light.")
        @Range(min = 0, max = 3)
        @Unit("ln")
        double contrast) {
  /** Checks the values. */
  public BodySettings {
    SettingsSchema.validate(
        BodySettings.class,
        offsetXPx,
        offsetYPx,
        headingRad,
        lengthPx,
        hingeOffsetPx,
        wobblePx,
        driftPx,
        contrast);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static BodySettings defaults() {
    return new BodySettings(0, 0, 1.5707963267948966, 44, 3, 0.4, 0.5, 1.5);
  }
}
