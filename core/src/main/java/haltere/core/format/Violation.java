package haltere.core.format;

/**
 * Deviations of a recording from its format. Decoders count them and continue if possible.
 *
 * @since 0.1
 */
public enum Violation {
  /** An event outside the sensor; it is skipped. */
  OUTSIDE_SENSOR("events outside of the sensor were left out"),
  /** A backward jump of the clock other than a wrap; the stream has a notification of it. */
  CLOCK_WENT_BACK("jumps back of the clock"),
  /** The file ends within an event or a packet; the complete ones have been read. */
  CUT_OFF("the file ends in the middle of an event or packet"),
  /** Words that the format does not define; they are skipped. */
  UNKNOWN_WORD("words that are invalid in this format were left out"),
  /** An impossible length, count or size; the data with it is skipped. */
  IMPOSSIBLE_LENGTH("impossible lengths or counts"),
  /** A packet that cannot be decompressed; it is skipped. */
  DAMAGED_PACKET("damaged packets were left out"),
  /** Messages lost before recording, as gaps in the message numbers show. */
  MISSING_MESSAGE("messages were lost before they were recorded"),
  /** Events before the first time word; they are skipped. */
  NO_TIME_YET("events before the first time word were left out"),
  /** Data other than polarity events (frames, inertial samples, triggers). */
  OTHER_DATA("words hold data other than polarity events, which are not read"),
  /** An incomplete or invalid frame or inertial sample. */
  INCOMPLETE_SAMPLE("incomplete frames or inertial samples were left out");

  private final String description;

  Violation(String description) {
    this.description = description;
  }

  /**
   * Description for users.
   *
   * @return a few words that can follow a count
   */
  public String description() {
    return description;
  }

  /**
   * Whether it indicates damage, rather than data that is not read or a recording that began within
   * the camera's stream.
   *
   * @return true for damage
   */
  public boolean isDamage() {
    return switch (this) {
      case OTHER_DATA, NO_TIME_YET, MISSING_MESSAGE, INCOMPLETE_SAMPLE -> false;
      default -> true;
    };
  }
}
