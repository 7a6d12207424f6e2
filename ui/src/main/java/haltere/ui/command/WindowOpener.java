package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.nio.file.Path;
import java.util.Optional;

/** Opens the viewer's window; separates the commands, which need no display, from the viewer. */
public interface WindowOpener {
  /** The reason why no window can open, with advice; empty if it can. */
  Optional<String> obstacle();

  /** Whether there is a display; false on a server or in a container. */
  boolean hasDisplay();

  /**
   * Opens the viewer on a recording, or on the built-in scene without one, and returns after it has
   * been closed: the reason if it could not open, else empty.
   */
  Optional<String> open(Optional<Path> file, ReadOptions options);

  /** Opens the viewer on its start page and returns as {@link #open} does. */
  default Optional<String> openStartPage() {
    return open(Optional.empty(), ReadOptions.DEFAULT);
  }
}
