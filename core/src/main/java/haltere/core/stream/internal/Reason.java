package haltere.core.stream.internal;

import java.io.UncheckedIOException;

/** The reason of a failure, for a line to users. */
public final class Reason {
  private Reason() {}

  /**
   * The reason of a failure.
   *
   * @param failure any failure; one of a file is that which it wraps
   * @return its message, or its type if it has none
   */
  public static String of(Throwable failure) {
    if (failure instanceof UncheckedIOException) {
      return of(failure.getCause());
    }
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }
}
