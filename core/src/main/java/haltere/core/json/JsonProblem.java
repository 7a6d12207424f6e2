package haltere.core.json;

import java.io.IOException;

/**
 * Invalid JSON; the message names the file and the line.
 *
 * @since 0.1
 */
public final class JsonProblem extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem.
   *
   * @param message names the position and the problem
   */
  public JsonProblem(String message) {
    super(message);
  }
}
