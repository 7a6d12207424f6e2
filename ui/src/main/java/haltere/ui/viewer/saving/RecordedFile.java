package haltere.ui.viewer.saving;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Recorder;
import haltere.core.pipeline.RecorderReport;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PlayedOutput;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;

/**
 * A file that takes what comes out of the chain while it plays, as AEDAT-4 that can be read
 * whenever the program ends; one that is there is replaced. A jump ends it; what came until then is
 * kept.
 *
 * @param file where it is
 * @param sink what it gets of the stream
 * @param isOver whether it takes no more, because of a jump, the end or a full disk
 * @param ending ends it, as {@link #finish()}
 */
record RecordedFile(Path file, StreamHandler sink, BooleanSupplier isOver, Callable<String> ending)
    implements PlayedOutput.Output {
  private static final String UNTIL_JUMP = ", until playback jumped";

  /** A file for what is open. */
  static RecordedFile of(Path file, ViewerSession session) throws IOException {
    return session.camera().isPresent()
        ? ofCamera(file, session.camera().get().camera(), session.chain())
        : ofRecording(file, session.player().playable().geometry());
  }

  @Override
  public String begun() {
    return "Recording to " + file.getFileName();
  }

  @Override
  public String finish() throws Exception {
    return ending.call();
  }

  private static RecordedFile ofRecording(Path file, SensorGeometry geometry) throws IOException {
    Recorder recorder =
        Recorder.inPlace(file, WriteOptions.of(geometry).withOverwrite(true), OverflowPolicy.BLOCK);
    return new RecordedFile(
        file,
        recorder,
        () -> recorder.report().stoppedBy().isPresent(),
        () -> {
          RecorderReport report = recorder.finish();
          boolean jumped = report.stoppedBy().filter(Reset.class::isInstance).isPresent();
          return words(file, report.written()) + (jumped ? UNTIL_JUMP : "");
        });
  }

  /**
   * A recording of a camera, which says in its header what the camera and the chain were set to,
   * and goes on in another part where the camera's clock starts anew.
   */
  private static RecordedFile ofCamera(Path file, Camera camera, FilterChain chain)
      throws IOException {
    SessionRecorder session =
        SessionRecorder.ofCamera(
            file,
            camera,
            () -> Optional.of(ChainFile.write(chain)),
            (part, metadata) ->
                Aedat4Writer.createInPlace(
                    part,
                    new WriteOptions(camera.geometry(), true, Optional.empty(), metadata),
                    Aedat4Compression.LZ4),
            SessionRecorder.Limits.USUAL);
    return new RecordedFile(
        file,
        session,
        () -> session.endedEarly().isPresent(),
        () -> {
          List<SessionRecorder.Part> parts = session.finish();
          long events = parts.stream().mapToLong(part -> part.report().written()).sum();
          long lost = parts.stream().mapToLong(part -> part.report().lost()).sum();
          return words(file, events)
              + (parts.size() > 1 ? " in " + parts.size() + " parts" : "")
              + (parts.stream().anyMatch(part -> part.report().afterStop() > 0) ? UNTIL_JUMP : "")
              + (lost > 0 ? "; the disk was too slow for " + Texts.count(lost) : "")
              + session.endedEarly().map(line -> "; " + line).orElse("");
        });
  }

  private static String words(Path file, long events) {
    return "Recorded " + Texts.count(events) + " events to " + file.getFileName();
  }
}
