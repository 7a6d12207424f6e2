package haltere.core.format;

/**
 * Deviations of a recording from its format. Decoders count them and continue if possible.
 *
 * @since 0.1
 */
public enum Violation {
  /** An event outside the sensor; it is skipped. */
  OUTSIDE_SENSOR(
      "event outside of the sensor was left out", "events outside of the sensor were left out"),
  /** A backward jump of the clock other than a wrap; the stream has a notification of it. */
  CLOCK_WENT_BACK("jump back of the clock", "jumps back of the clock"),
  /** A step back by 1 ms or less; events before the newest time get that time. */
  OUT_OF_ORDER(
      "step back of the clock by 1 ms or less: late events got the time of the one before them",
      "steps back of the clock by 1 ms or less: late events got the times of those before them"),
  /** The file ends within an event or a packet; the complete ones have been read. */
  CUT_OFF("the file ends in the middle of an event or packet"),
  /** Words that the format does not define; they are skipped. */
  UNKNOWN_WORD(
      "word that is invalid in this format was left out",
      "words that are invalid in this format were left out"),
  /** An impossible length, count or size; the data with it is skipped. */
  IMPOSSIBLE_LENGTH("impossible length or count", "impossible lengths or counts"),
  /** A packet that cannot be decompressed; it is skipped. */
  DAMAGED_PACKET("damaged packet was left out", "damaged packets were left out"),
  /** Messages lost before recording, as gaps in the message numbers show. */
  MISSING_MESSAGE(
      "message was lost before it was recorded", "messages were lost before they were recorded"),
  /** Events before the first time word; they are skipped. */
  NO_TIME_YET(
      "event before the first time word was left out",
      "events before the first time word were left out"),
  /** Data other than polarity events (frames, inertial samples, triggers). */
  OTHER_DATA(
      "word holds data other than polarity events, which is not read",
      "words hold data other than polarity events, which are not read"),
  /** An incomplete or invalid frame or inertial sample. */
  INCOMPLETE_SAMPLE(
      "incomplete frame or inertial sample was left out",
      "incomplete frames or inertial samples were left out");

  private final String one;
  private final String several;

  Violation(String always) {
    this(always, always);
  }

  Violation(String one, String several) {
    this.one = one;
    this.several = several;
  }

  /**
   * Description for users.
   *
   * @return a few words that can follow a count of several
   */
  public String description() {
    return several;
  }

  /** Description for users, which can follow this count. */
  String description(long count) {
    return count == 1 ? one : several;
  }

  /**
   * Whether it indicates damage, rather than a clock that goes back, data that is not read or a
   * recording that began within the camera's stream.
   *
   * @return true for damage
   */
  public boolean isDamage() {
    return switch (this) {
      case CLOCK_WENT_BACK,
              OUT_OF_ORDER,
              OTHER_DATA,
              NO_TIME_YET,
              MISSING_MESSAGE,
              INCOMPLETE_SAMPLE ->
          false;
      default -> true;
    };
  }
}
