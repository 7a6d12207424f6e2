package haltere.core.event;

/**
 * Kinds of data of a camera other than polarity events.
 *
 * @since 0.1
 */
public enum SampleKind {
  /** A picture of the whole sensor or of a part of it. */
  FRAME("frame", "frames"),
  /** A measurement of the inertial sensor of the camera. */
  INERTIAL_SAMPLE("inertial sample", "inertial samples"),
  /** An edge of an input, or another time marked by the camera. */
  TRIGGER("trigger", "triggers");

  private final String singular;
  private final String plural;

  SampleKind(String singular, String plural) {
    this.singular = singular;
    this.plural = plural;
  }

  /**
   * The plural of the kind.
   *
   * @return such as "triggers"
   */
  public String plural() {
    return plural;
  }

  /**
   * A count of this kind for users.
   *
   * @param number at least 0
   * @return such as "1 frame" or "7 triggers"
   */
  public String count(long number) {
    return number + " " + (number == 1 ? singular : plural);
  }
}
