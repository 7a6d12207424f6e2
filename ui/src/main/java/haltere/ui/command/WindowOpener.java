package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Opens the viewer's window. It stands between the commands, which run without a display, and the
 * viewer, which needs one.
 */
public interface WindowOpener {
  /**
   * What keeps a window from opening here.
   *
   * @return one line that says what to do, or empty if a window can open
   */
  Optional<String> obstacle();

  /**
   * Whether there is a display at all, so that a window is what the user expects.
   *
   * @return false on a server or in a container
   */
  boolean hasDisplay();

  /**
   * Opens the viewer and returns when it has been closed.
   *
   * @param file a recording, or empty for the built-in scene
   * @param options what the user says about the recording
   * @return empty if the window was open and has been closed; one line that says why not otherwise
   */
  Optional<String> open(Optional<Path> file, ReadOptions options);

  /**
   * Opens the viewer on its start page and returns when it has been closed.
   *
   * @return as {@link #open}
   */
  default Optional<String> openStartPage() {
    return open(Optional.empty(), ReadOptions.DEFAULT);
  }
}
