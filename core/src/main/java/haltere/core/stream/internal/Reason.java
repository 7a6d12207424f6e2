package haltere.core.stream.internal;

/** The reason of a failure, for a line to users. */
public final class Reason {
  private Reason() {}

  /**
   * The reason of a failure.
   *
   * @param failure any failure
   * @return its message, or its type if it has none
   */
  public static String of(Throwable failure) {
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }
}
