package haltere.core.chain;

/**
 * An invalid description of a chain; the message has the reason and the valid choices.
 *
 * @since 0.1
 */
public final class ChainProblem extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem.
   *
   * @param message for users
   */
  public ChainProblem(String message) {
    super(message);
  }
}
