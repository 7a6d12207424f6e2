package haltere.ui.viewer.saving;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.CameraHeader;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Recorder;
import haltere.core.pipeline.RecorderReport;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.playback.Player;
import haltere.core.stream.StreamHandler;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.BackgroundWork;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
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
  /** Writes what is handed to it. */
  private interface Writing extends AutoCloseable {
    StreamHandler sink();

    /** Ends it; what was written, in words for a person. */
    String finish() throws IOException;

    @Override
    void close() throws IOException;
  }

  /** A recording under way. */
  private record Under(Player player, Writing writing, Path file) {}

  private static final String UNTIL_JUMP = ", until playback jumped";

  private final BackgroundWork background;
  private final Consumer<String> problems;
  private final Consumer<String> said;
  private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper();
  private Optional<Under> under = Optional.empty();
  private int starts;

  /**
   * Records nothing yet; tells in one line what went wrong and what is going on, empty when there
   * is nothing more to say.
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

  /** The file that is being written. */
  Optional<Path> file() {
    return under.map(Under::file);
  }

  /**
   * Starts to record; a file that is there is replaced. A recording of a camera says in its header
   * what the camera and the chain were set to, and goes on in another part where the camera's clock
   * starts anew.
   */
  void start(Path file, ViewerSession session) {
    stop();
    int start = ++starts;
    Player player = session.player();
    recording.set(true);
    background.file(
        () ->
            session.camera().isPresent()
                ? ofCamera(file, session.camera().get().camera(), session.chain())
                : ofRecording(file, player.playable().geometry()),
        writing -> begin(start, new Under(player, writing, file)),
        problem -> {
          recording.set(false);
          problems.accept(Texts.oneLine(problem));
        });
  }

  private static Writing ofRecording(Path file, SensorGeometry geometry) throws IOException {
    Recorder recorder =
        Recorder.inPlace(file, WriteOptions.of(geometry).withOverwrite(true), OverflowPolicy.BLOCK);
    return new Writing() {
      @Override
      public StreamHandler sink() {
        return recorder;
      }

      @Override
      public String finish() throws IOException {
        RecorderReport report = recorder.finish();
        return words(file, report.written()) + (report.afterStop() > 0 ? UNTIL_JUMP : "");
      }

      @Override
      public void close() throws IOException {
        recorder.close();
      }
    };
  }

  private static Writing ofCamera(Path file, Camera camera, FilterChain chain) throws IOException {
    SessionRecorder session =
        new SessionRecorder(
            file,
            camera.geometry(),
            (part, metadata) ->
                Aedat4Writer.createInPlace(
                    part,
                    new WriteOptions(camera.geometry(), true, Optional.empty(), metadata),
                    Aedat4Compression.LZ4),
            SessionRecorder.Limits.USUAL,
            new CameraHeader(
                camera,
                () -> Optional.of(ChainFile.write(chain)),
                System::nanoTime,
                Clock.systemUTC()),
            SessionRecorder.freeBytes(file));
    session.checkSpace();
    return new Writing() {
      @Override
      public StreamHandler sink() {
        return session;
      }

      @Override
      public String finish() throws IOException {
        List<SessionRecorder.Part> parts = session.finish();
        long events = parts.stream().mapToLong(part -> part.report().written()).sum();
        long lost = parts.stream().mapToLong(part -> part.report().lost()).sum();
        return words(file, events)
            + (parts.size() > 1 ? " in " + parts.size() + " parts" : "")
            + (parts.stream().anyMatch(part -> part.report().afterStop() > 0) ? UNTIL_JUMP : "")
            + (lost > 0 ? "; the disk was too slow for " + Texts.count(lost) : "")
            + session.endedEarly().map(line -> "; " + line).orElse("");
      }

      @Override
      public void close() throws IOException {
        session.close();
      }
    };
  }

  private void begin(int start, Under begun) {
    if (start != starts || !recording.get()) {
      background.close(begun.writing());
      return;
    }
    under = Optional.of(begun);
    begun.player().addSink(begun.writing().sink());
    said.accept("Recording to " + begun.file().getFileName());
  }

  /** Ends the recording that is under way, if there is one. */
  void stop() {
    recording.set(false);
    under.ifPresent(
        ended ->
            background.file(
                () -> finish(ended), said, problem -> problems.accept(Texts.oneLine(problem))));
    under = Optional.empty();
  }

  /** In the background; a player that has been closed hands over nothing more anyway. */
  private static String finish(Under ended) throws IOException {
    ended.player().removeSink(ended.writing().sink()).exceptionally(closed -> null).join();
    return ended.writing().finish();
  }

  private static String words(Path file, long events) {
    return "Recorded " + Texts.count(events) + " events to " + file.getFileName();
  }
}
