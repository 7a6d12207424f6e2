package haltere.filters.orientation;

/** What becomes of observations and instants; each is counted. */
public enum OrientationCount {
  /** Observations used for the axis. */
  USED("used for the axis"),
  /** Lines outside the gate, or likelier not the body's. */
  REJECTED("rejected by the gate"),
  /** Observations whose area is too small. */
  SMALL("too small"),
  /** Observations that are too round. */
  ROUND("too round"),
  /** Observations without an angle; their place may have been used. */
  WITHOUT_ANGLE("without an angle"),
  /** Observations of a camera that cannot be used, or at places that its lens does not show. */
  UNUSABLE_CAMERA("of a camera that cannot be used, or where its lens shows nothing"),
  /** Lines that a camera cannot see: of a body at its centre, in its plane, or seen end-on. */
  WITHOUT_LINE("of a body at the camera's centre, in its plane or seen end-on"),
  /** A second observation of one camera at one time. */
  TWICE("second ones of a camera at one time"),
  /** Observations from before one that was already taken in. */
  TIME_BACK("earlier than the one before"),
  /** Instants at which the place was not known: fewer than two cameras, or all in one line. */
  NO_PLACE(
      "instants without a place: fewer than two cameras, or all of them in line with the body"),
  /** Times with a position but no axis: fewer than two accepted lines, or lines of one plane. */
  NO_AXIS(
      "instants without an axis: fewer than two accepted lines, lines that tell the same or"
          + " contradict"),
  /** How often an axis was found anew after one was lost. */
  RELAUNCHED("times that a lost axis was found anew");

  private final String words;

  OrientationCount(String words) {
    this.words = words;
  }

  /**
   * What is counted, for a person.
   *
   * @return words that follow a number
   */
  public String words() {
    return words;
  }
}
