package haltere.core.format;

/**
 * Deviations of a recording from its format. Decoders count them and continue if possible.
 *
 * @since 0.1
 */
public enum Violation {
  /** An event's pixel is not on the sensor; the event is left out. */
  OUTSIDE_SENSOR("events outside of the sensor were left out"),
  /** The clock went back without being a wrap; the stream has a notification there. */
  CLOCK_WENT_BACK("jumps back of the clock"),
  /** The file ends in the middle of an event or a packet; what was whole has been read. */
  CUT_OFF("the file ends in the middle of an event or packet"),
  /** Words that the format does not define; they are left out. */
  UNKNOWN_WORD("words that are invalid in this format were left out"),
  /** A length, count or size that cannot be true; what it belongs to is left out. */
  LYING_LENGTH("impossible lengths or counts"),
  /** A packet that cannot be decompressed; it is left out. */
  DAMAGED_PACKET("damaged packets were left out"),
  /** Messages that were lost before they were recorded, by the numbers of those that were not. */
  MISSING_MESSAGE("messages were lost before they were recorded"),
  /** Events before the first word that tells the time; they are left out. */
  NO_TIME_YET("events before the first time word were left out"),
  /** Data of another kind than polarity events (frames, inertial samples, triggers). */
  OTHER_DATA("words hold data other than polarity events, which are not read"),
  /** A frame or an inertial sample of which a part is missing, or that cannot be true. */
  INCOMPLETE_SAMPLE("incomplete frames or inertial samples were left out");

  private final String sentence;

  Violation(String sentence) {
    this.sentence = sentence;
  }

  /**
   * What it means, for users.
   *
   * @return a few words that can follow a count
   */
  public String sentence() {
    return sentence;
  }

  /**
   * Whether it says that the file is damaged, rather than that it holds more than is read or that
   * the recording began in the middle of the camera's stream.
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
