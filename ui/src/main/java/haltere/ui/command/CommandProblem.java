package haltere.ui.command;

/** A command failed; the message is the one line for the user, without a stack trace. */
final class CommandProblem extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CommandProblem(String message) {
    super(message);
  }

  CommandProblem(String message, Throwable cause) {
    super(message, cause);
  }
}
