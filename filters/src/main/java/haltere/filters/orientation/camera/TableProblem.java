package haltere.filters.orientation.camera;

import java.io.IOException;

/** A file is not the table that it should be; the message is one line that names it. */
public final class TableProblem extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem.
   *
   * @param message one line that names the file and, where there is one, the line
   */
  public TableProblem(String message) {
    super(message);
  }
}
