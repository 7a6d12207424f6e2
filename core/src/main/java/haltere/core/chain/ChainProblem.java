package haltere.core.chain;

/**
 * A chain that cannot be made as described; the message says what is wrong and what would do.
 *
 * @since 0.1
 */
public final class ChainProblem extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem.
   *
   * @param message for a person
   */
  public ChainProblem(String message) {
    super(message);
  }
}
