package haltere.filters.cluster;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The a-priori shape of clusters. */
public record ClusterShapeSettings(
    @Help("A-priori radius of a cluster as a share of the longer side of the sensor.")
        @Range(min = 0.005, max = 0.5, logarithmic = true)
        @Unit("1")
        double size,
    @Help(
            value = "Height over width of a cluster; its area stays the same.",
            label = "Aspect ratio")
        @Range(min = 0.1, max = 10, logarithmic = true)
        @Unit("1")
        double aspect,
    @Help("Rotation of the cluster, counterclockwise.") @Range(min = -180, max = 180) @Unit("deg")
        double angleDeg,
    @Help(
            value =
                "Source of the angle: fixed, the principal axis of the events, or the velocity.",
            label = "Source of the angle")
        Angle angle,
    @Help("A cluster is a box or the ellipse in it.") Type type) {
  /** Source of the angle of a cluster's width. */
  public enum Angle {
    /** The angle that is set. */
    FIXED,
    /** The principal axis of the events' second moments. */
    OF_EVENTS,
    /** The direction of the velocity; kept while the cluster stands still. */
    OF_VELOCITY
  }

  /** Shape of a cluster. */
  public enum Type {
    /** The ellipse of the two half axes. */
    ELLIPSE,
    /** The box around this ellipse, rotated with it. */
    BOX
  }

  /** Checks the ranges. */
  public ClusterShapeSettings {
    SettingsSchema.validate(ClusterShapeSettings.class, size, aspect, angleDeg, angle, type);
  }

  /** {@return the default settings: an upright square whose radius is 0.06 of the longer side} */
  public static ClusterShapeSettings defaults() {
    return new ClusterShapeSettings(0.06, 1, 0, Angle.FIXED, Type.BOX);
  }
}
