package haltere.filters.orientation;

/** Counts of observations and times, by result. */
public enum OrientationCount {
  /** Observations used for the axis. */
  USED("used for the axis"),
  /** Lines outside the gate, or likelier not the body's. */
  REJECTED("rejected by the gate"),
  /** Observations whose area is too small. */
  SMALL("too small"),
  /** Observations that are too round. */
  ROUND("too round"),
  /** Observations without an angle; their position may have been used. */
  WITHOUT_ANGLE("without an angle"),
  /** Observations of an unusable camera, or outside the image of its lens. */
  UNUSABLE_CAMERA("of a camera that cannot be used, or where its lens shows nothing"),
  /** Lines that a camera cannot see: of a body at its centre, in its plane, or seen end-on. */
  WITHOUT_LINE("of a body at the camera's centre, in its plane or seen end-on"),
  /** A second observation of one camera at one time. */
  TWICE("second ones of a camera at one time"),
  /** Observations earlier than one that was already used. */
  TIME_BACK("earlier than the one before"),
  /** Times without a position: fewer than two cameras, or all in one line. */
  NO_POSITION(
      "times without a position: fewer than two cameras, or all of them in line with the body"),
  /** Times with a position but no axis: fewer than two accepted lines, or lines of one plane. */
  NO_AXIS(
      "times without an axis: fewer than two accepted lines, lines of one plane or lines that"
          + " contradict"),
  /** How often an axis was found anew after one was lost. */
  RELAUNCHED("times that a lost axis was found anew");

  private final String words;

  OrientationCount(String words) {
    this.words = words;
  }

  /** {@return what is counted, in words that follow a number} */
  public String words() {
    return words;
  }
}
