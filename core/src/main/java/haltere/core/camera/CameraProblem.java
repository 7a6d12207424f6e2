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

  /** What is wrong, for a program. */
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
    /** Its firmware, its logic or this computer is one that this program does not know. */
    UNSUPPORTED,
    /** Anything else between this computer and the camera. */
    BROKEN
  }

  private final Kind kind;

  /**
   * A problem.
   *
   * @param kind what is wrong, for a program
   * @param message what is wrong and what to do, for users
   */
  public CameraProblem(Kind kind, String message) {
    super(message);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  /**
   * What is wrong.
   *
   * @return a kind
   */
  public Kind kind() {
    return kind;
  }
}
