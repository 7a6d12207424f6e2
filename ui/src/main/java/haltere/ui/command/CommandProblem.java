package haltere.ui.command;

/** The work cannot be done; the message is the one line that the user sees, without a trace. */
final class CommandProblem extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CommandProblem(String message) {
    super(message);
  }

  CommandProblem(String message, Throwable cause) {
    super(message, cause);
  }
}
