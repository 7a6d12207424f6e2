package haltere.ui.viewer.session;

import haltere.core.format.ReadOptions;
import haltere.core.playback.Playable;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import javafx.beans.property.ReadOnlyObjectProperty;

/**
 * What is open, and how something else is opened.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public interface SessionHost {
  /** The session that is shown; empty until the first one has been opened. */
  ReadOnlyObjectProperty<Optional<ViewerSession>> sessionProperty();

  /**
   * Opens something in place of what is open. Filters that a person has chosen stay. Returns at
   * once.
   */
  void open(SessionRequest request);

  /** Opens a recording. */
  default void open(Path file, ReadOptions options) {
    open(SessionRequest.recording(file, options));
  }

  /**
   * Opens what is not a file.
   *
   * @param playable makes it, on a background thread
   * @param name what a person would call it
   */
  default void open(Callable<Playable> playable, String name) {
    open(SessionRequest.made(playable, name));
  }

  /** The session that is shown. */
  default Optional<ViewerSession> session() {
    return sessionProperty().get();
  }
}
