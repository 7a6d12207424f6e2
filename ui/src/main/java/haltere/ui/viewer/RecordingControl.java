package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.core.format.WriteOptions;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Recorder;
import haltere.core.pipeline.RecorderReport;
import haltere.core.playback.Player;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;

/**
 * Records what comes out of the chain while it plays, as AEDAT-4 that can be read whenever the
 * program ends. A jump ends the recording; what came until then is kept.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
final class RecordingControl {
  /** A recording under way. */
  private record Under(Player player, Recorder recorder, Path file) {}

  private final BackgroundWork background;
  private final Consumer<String> problems;
  private final Consumer<String> said;
  private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper();
  private Optional<Under> under = Optional.empty();
  private int starts;

  /**
   * Records nothing yet.
   *
   * @param problems takes what went wrong, in one line
   * @param said takes what is going on, in one line, empty when there is nothing more to say
   */
  RecordingControl(BackgroundWork background, Consumer<String> problems, Consumer<String> said) {
    this.background = background;
    this.problems = problems;
    this.said = said;
  }

  /** Whether a recording is under way. */
  ReadOnlyBooleanProperty recordingProperty() {
    return recording.getReadOnlyProperty();
  }

  /** Starts to record; a file that is there is replaced. */
  void start(Path file, Player player) {
    stop();
    int start = ++starts;
    SensorGeometry geometry = player.playable().geometry();
    recording.set(true);
    background.file(
        () ->
            Recorder.inPlace(
                file, WriteOptions.of(geometry).withOverwrite(true), OverflowPolicy.BLOCK),
        recorder -> begin(start, new Under(player, recorder, file)),
        problem -> {
          recording.set(false);
          problems.accept(Texts.oneLine(problem));
        });
  }

  private void begin(int start, Under begun) {
    if (start != starts || !recording.get()) {
      background.close(begun.recorder());
      return;
    }
    under = Optional.of(begun);
    begun.player().addSink(begun.recorder());
    said.accept("Recording to " + begun.file().getFileName());
  }

  /** Ends the recording that is under way, if there is one. */
  void stop() {
    recording.set(false);
    under.ifPresent(
        ended ->
            background.file(
                () -> finish(ended),
                report -> said.accept(words(ended.file(), report)),
                problem -> problems.accept(Texts.oneLine(problem))));
    under = Optional.empty();
  }

  /** In the background; a player that has been closed hands over nothing more anyway. */
  private static RecorderReport finish(Under ended) throws IOException {
    ended.player().removeSink(ended.recorder()).exceptionally(closed -> null).join();
    return ended.recorder().finish();
  }

  private static String words(Path file, RecorderReport report) {
    return "Recorded "
        + Texts.count(report.written())
        + " events to "
        + file.getFileName()
        + (report.afterStop() > 0 ? ", until playback jumped" : "");
  }
}
