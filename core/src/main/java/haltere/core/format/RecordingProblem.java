package haltere.core.format;

import haltere.core.stream.internal.Reason;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.channels.ClosedChannelException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * A recording that cannot be read or written. The message is one line for users: file, byte offset
 * if known, cause and advice.
 *
 * @since 0.1
 */
public final class RecordingProblem extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * The problem of a failed write, for users: file, cause and advice.
   *
   * @param file the file
   * @param cause exception of the system
   * @return a problem of the file, or the cause itself if it already names a file or is an
   *     interruption
   */
  public static IOException writing(Path file, IOException cause) {
    return of(file.toString(), "cannot be written: ", cause);
  }

  /**
   * The problem of a failed read, for users, as {@link #writing}.
   *
   * @param file the file
   * @param offset byte offset in it
   * @param cause exception of the system
   * @return as {@link #writing}
   */
  public static IOException reading(Path file, long offset, IOException cause) {
    return of(file + ", byte " + offset, "cannot be read: ", cause);
  }

  private static IOException of(String place, String verb, IOException cause) {
    if (cause instanceof RecordingProblem
        || cause instanceof InterruptedIOException
        || cause instanceof ClosedChannelException) {
      return cause;
    }
    String reason = Reason.withoutFile(cause);
    return new RecordingProblem(place + ": " + verb + reason + advice(reason), cause);
  }

  /** A problem that the system reports, not the content of the file. */
  static RecordingProblem of(Path file, String message, IOException cause) {
    return new RecordingProblem(file + ": " + message, cause);
  }

  private static String advice(String reason) {
    String lower = reason.toLowerCase(Locale.ROOT);
    if (lower.contains("space") || lower.contains("quota")) {
      return "; make room, or choose another disk";
    }
    if (lower.contains("too large")) {
      return "; the disk or a limit (ulimit -f) allows no larger file: choose another place";
    }
    if (lower.contains("input/output error") || lower.contains("i/o error")) {
      return "; the disk or its connection is faulty: copy what can be read to another one";
    }
    if (lower.contains("read-only")) {
      return "; choose another place";
    }
    return "";
  }

  private RecordingProblem(String line, IOException cause) {
    super(line, cause);
  }

  /**
   * A problem with a file as a whole.
   *
   * @param file the file
   * @param message cause and advice
   */
  public RecordingProblem(Path file, String message) {
    super(file + ": " + message);
  }

  /**
   * A problem at an offset.
   *
   * @param file the file
   * @param offset byte offset in it
   * @param message cause and advice
   */
  public RecordingProblem(Path file, long offset, String message) {
    super(file + ", byte " + offset + ": " + message);
  }
}
