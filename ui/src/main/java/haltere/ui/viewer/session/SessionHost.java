package haltere.ui.viewer.session;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.playback.Playable;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BiConsumer;
import javafx.beans.property.ReadOnlyObjectProperty;

/**
 * What is open, and how something else is opened.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public interface SessionHost {
  /** The session that is shown; empty until the first one has been opened. */
  ReadOnlyObjectProperty<Optional<ViewerSession>> sessionProperty();

  /** What reading all of the recording has told; empty until then, and for what is no recording. */
  ReadOnlyObjectProperty<Optional<RecordingFacts>> factsProperty();

  /** Tells somebody of what could not be opened, by its name. */
  void onProblem(BiConsumer<String, Exception> listener);

  /** Remembers the sensor of the recording that is open, for the next time that it is opened. */
  void keepSensor(SensorGeometry sensor);

  /**
   * Opens something in place of what is open. Filters that a person has chosen stay. Returns at
   * once.
   */
  void open(SessionRequest request);

  /** Opens a recording, which tells all that there is to know of it. */
  default void open(Path file) {
    open(file, ReadOptions.DEFAULT);
  }

  /** Opens a recording. */
  default void open(Path file, ReadOptions options) {
    open(SessionRequest.recording(file, options));
  }

  /**
   * Opens what is not a file under the name that a person would call it, made on a background
   * thread.
   */
  default void open(Callable<Playable> playable, String name) {
    open(SessionRequest.made(playable, name));
  }

  /** The session that is shown. */
  default Optional<ViewerSession> session() {
    return sessionProperty().get();
  }
}
