package haltere.core.stream.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** The reason of a failure, for a line to users. */
public final class Reason {
  private Reason() {}

  /**
   * The reason of a failure.
   *
   * @param failure any failure; one of a file is that which it wraps
   * @return its message, or its type if it has none; that of a file also has the reason
   */
  public static String of(Throwable failure) {
    if (failure instanceof UncheckedIOException) {
      return of(failure.getCause());
    }
    if (failure instanceof FileSystemException named && named.getReason() == null) {
      String file = named.getFile() == null ? "" : named.getMessage() + ": ";
      return file + withoutFile(named);
    }
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }

  /**
   * The reason of a failure without the name of the file, which may be a temporary one.
   *
   * @param failure a failure of the system
   * @return its reason
   */
  public static String withoutFile(IOException failure) {
    if (failure instanceof NoSuchFileException) {
      return "there is no such file or folder";
    }
    if (failure instanceof AccessDeniedException) {
      return "no permission";
    }
    if (failure instanceof FileSystemException named) {
      return named.getReason() == null ? "cannot be used" : named.getReason();
    }
    return of(failure);
  }
}
