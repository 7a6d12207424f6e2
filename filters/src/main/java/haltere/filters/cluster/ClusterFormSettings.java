package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Which form clusters have to begin with, and what of it they keep.
 *
 * @param size radius as a share of the sensor's longer side
 * @param aspect height over width
 * @param angleDeg how far the form is turned counterclockwise, degrees
 * @param angle where the angle comes from later on
 * @param outline which events are inside
 */
public record ClusterFormSettings(
    @Help("Radius that a cluster begins with, as a share of the longer side of the sensor.")
        @Range(min = 0.005, max = 0.5, logarithmic = true)
        @Unit("1")
        double size,
    @Help("Height over width of a cluster; its area stays the same.")
        @Range(min = 0.1, max = 10, logarithmic = true)
        @Unit("1")
        double aspect,
    @Help("How far the form is turned, counterclockwise.")
        @Range(min = -180, max = 180)
        @Unit("deg")
        double angleDeg,
    @Help("Whether the angle stays, is that of the events' spread, or that of the velocity.")
        Angle angle,
    @Help("Whether a cluster is an ellipse or a box.") Outline outline) {
  /** Where the angle of a cluster comes from. */
  public enum Angle {
    /** The angle that is set. */
    FIXED,
    /** The direction in which the events are spread the most. */
    OF_EVENTS,
    /** The direction of the motion; while there is none, as it was. */
    OF_VELOCITY
  }

  /** Which events are inside. */
  public enum Outline {
    /** Those in the ellipse of the two half axes. */
    ELLIPSE,
    /** Those in the box around this ellipse, turned with it. */
    BOX
  }

  /** Checks the ranges. */
  public ClusterFormSettings {
    SettingsSchema.validate(ClusterFormSettings.class, size, aspect, angleDeg, angle, outline);
  }

  /**
   * The default form.
   *
   * @return an ellipse that begins as a circle of 0.06 of the longer side
   */
  public static ClusterFormSettings defaults() {
    return new ClusterFormSettings(0.06, 1, 0, Angle.OF_EVENTS, Outline.ELLIPSE);
  }
}
