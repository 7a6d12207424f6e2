package haltere.core.format;

import java.io.IOException;
import java.nio.file.Path;

/**
 * A recording that cannot be read or written. The message is one line for a person: the file, the
 * byte offset where there is one, what is wrong and what to do.
 */
public final class RecordingProblem extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem with a file as a whole.
   *
   * @param file which file
   * @param message what is wrong and what to do
   */
  public RecordingProblem(Path file, String message) {
    super(file + ": " + message);
  }

  /**
   * A problem at a place.
   *
   * @param file which file
   * @param offset byte offset in it
   * @param message what is wrong and what to do
   */
  public RecordingProblem(Path file, long offset, String message) {
    super(file + ", byte " + offset + ": " + message);
  }
}
