package haltere.core.overlay;

import java.util.Objects;

/**
 * The style of a mark, by its meaning; the canvas chooses colour and width.
 *
 * @param role what the mark stands for
 * @param identity marks of the same identity look alike; -1 for marks without one
 * @since 0.1
 */
public record MarkStyle(Role role, int identity) {
  /** Meaning of a mark. */
  public enum Role {
    /** An object that was found. */
    OBJECT,
    /** The path of an object. */
    PATH,
    /** The motion of an object. */
    VELOCITY,
    /** A raw measurement. */
    MEASUREMENT,
    /** An estimate. */
    ESTIMATE,
    /** The uncertainty of an estimate. */
    UNCERTAINTY,
    /** A region, line or point set by the user. */
    REGION,
    /** Something on the left of a body. */
    LEFT,
    /** Something on the right of a body. */
    RIGHT,
    /** A grid, an axis or another scale that lengths are read from. */
    SCALE,
    /** Text. */
    LABEL,
    /** Something that needs attention. */
    WARNING
  }

  /** Checks that the role is not null. */
  public MarkStyle {
    Objects.requireNonNull(role, "role");
  }

  /**
   * A style without identity.
   *
   * @param role what the mark stands for
   * @return a style
   */
  public static MarkStyle of(Role role) {
    return new MarkStyle(role, -1);
  }

  /**
   * A style with identity.
   *
   * @param role what the mark stands for
   * @param identity any number at least 0
   * @return a style
   */
  public static MarkStyle of(Role role, int identity) {
    return new MarkStyle(role, identity);
  }
}
