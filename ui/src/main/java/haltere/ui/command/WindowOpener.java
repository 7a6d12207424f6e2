package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Opens the viewer's window. It stands between the commands, which run without a display, and the
 * viewer, which needs one.
 */
public interface WindowOpener {
  /** What keeps a window from opening here: one line that says what to do; empty if it can open. */
  Optional<String> obstacle();

  /**
   * Whether there is a display, so that a window is expected; false on a server or in a container.
   */
  boolean hasDisplay();

  /**
   * Opens the viewer on a recording, or on the built-in scene without one, and returns when it has
   * been closed: one line that says why if it could not open, else empty.
   */
  Optional<String> open(Optional<Path> file, ReadOptions options);

  /** Opens the viewer on its start page and returns as {@link #open} does. */
  default Optional<String> openStartPage() {
    return open(Optional.empty(), ReadOptions.DEFAULT);
  }
}
