package haltere.core.camera;

import java.io.IOException;
import java.util.Objects;

/**
 * A failed operation of a camera; the message has the reason and advice.
 *
 * @since 0.1
 */
public final class CameraProblem extends IOException {
  private static final long serialVersionUID = 1L;

  /** The kind of problem, for programs. */
  public enum Kind {
    /** There is no such camera. */
    NOT_FOUND,
    /** This user may not open it. */
    NOT_PERMITTED,
    /** Another program has it. */
    BUSY,
    /** It was unplugged. */
    GONE,
    /** It did not answer in time. */
    TIMED_OUT,
    /** It rejected the request. */
    REFUSED,
    /** Its firmware, its logic or this computer is not supported. */
    UNSUPPORTED,
    /** Anything else between this computer and the camera. */
    BROKEN
  }

  private final Kind kind;

  /**
   * A problem.
   *
   * @param kind kind of problem, for programs
   * @param message cause and advice, for users
   */
  public CameraProblem(Kind kind, String message) {
    super(message);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  /**
   * The kind of problem.
   *
   * @return a kind
   */
  public Kind kind() {
    return kind;
  }
}
