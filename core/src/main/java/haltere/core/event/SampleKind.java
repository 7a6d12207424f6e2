package haltere.core.event;

/**
 * What a camera tells beside its polarity events.
 *
 * @since 0.1
 */
public enum SampleKind {
  /** A picture of the whole sensor or of a part of it. */
  FRAME("frame", "frames"),
  /** What the inertial sensor on the camera measured. */
  INERTIAL_SAMPLE("inertial sample", "inertial samples"),
  /** An edge on a wire, or another moment that the camera marked. */
  TRIGGER("trigger", "triggers");

  private final String one;
  private final String many;

  SampleKind(String one, String many) {
    this.one = one;
    this.many = many;
  }

  /**
   * What several of this kind are called.
   *
   * @return such as "triggers"
   */
  public String many() {
    return many;
  }

  /**
   * A count of this kind, for a person.
   *
   * @param number how many
   * @return such as "1 frame" or "7 triggers"
   */
  public String count(long number) {
    return number + " " + (number == 1 ? one : many);
  }
}
