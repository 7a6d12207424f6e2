package haltere.filters.orientation;

/** Counts of observations and times, by result. */
public enum OrientationCount {
  /** Observations used for the axis. */
  USED("used for the axis"),
  /** Lines outside the gate, and probable outliers. */
  REJECTED("rejected by the gate"),
  /** Observations whose area is too small. */
  SMALL("too small"),
  /** Observations that are too round. */
  ROUND("too round"),
  /** Observations without an angle; their position may have been used. */
  WITHOUT_ANGLE("without an angle"),
  /** Observations of an unusable camera, or outside the image of its lens. */
  UNUSABLE_CAMERA("of a camera that cannot be used, or outside the image of its lens"),
  /** Lines of a body at the camera's centre, in its focal plane, or pointing at it. */
  WITHOUT_LINE("of a body at the camera's centre, in its focal plane or pointing at it"),
  /** A second observation of one camera at one time. */
  DUPLICATE("further ones of a camera at the same time"),
  /** Observations earlier than one that was already used. */
  OUT_OF_ORDER("earlier than the previous one"),
  /** Times without a position: fewer than two cameras, or all collinear with the body. */
  NO_POSITION("times without a position: fewer than two cameras, or collinear with the body"),
  /** Times with a position but no axis: fewer than two accepted lines, or degenerate ones. */
  NO_AXIS("times without an axis: fewer than two accepted lines, coplanar or contradictory lines"),
  /** Re-initialisations of a lost axis. */
  REINITIALISED("re-initialisations of a lost axis");

  private final String description;

  OrientationCount(String description) {
    this.description = description;
  }

  /** {@return a description that follows a number} */
  public String description() {
    return description;
  }
}
