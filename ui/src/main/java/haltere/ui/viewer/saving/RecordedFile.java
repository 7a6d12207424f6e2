package haltere.ui.viewer.saving;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
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
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;

/**
 * An AEDAT-4 file of the events that the chain passes during playback, readable whenever the
 * program ends; an existing file is replaced. A jump ends it; the events before are kept.
 *
 * @param file where it is
 * @param sink its stream handler
 * @param ended whether it has ended, because of a jump, the end or a full disk
 * @param ending ends it, as {@link #finish()}
 */
record RecordedFile(Path file, StreamHandler sink, BooleanSupplier ended, Callable<String> ending)
    implements PlaybackOutput.Output {
  private static final String UNTIL_JUMP = ", until playback jumped";

  static RecordedFile of(Path file, ViewerSession session) throws IOException {
    session.request().checkOther(file);
    return session.camera().isPresent()
        ? ofCamera(file, session.camera().get().camera(), session.chain())
        : of(
            file,
            Recorder.inPlace(
                file,
                WriteOptions.of(session.player().playable().geometry()).withOverwrite(true),
                OverflowPolicy.BLOCK));
  }

  @Override
  public String startMessage() {
    return "Recording to " + file.getFileName();
  }

  @Override
  public boolean isOver() {
    return ended.getAsBoolean();
  }

  @Override
  public String finish() throws Exception {
    return ending.call();
  }

  static RecordedFile of(Path file, Recorder recorder) {
    return new RecordedFile(
        file,
        recorder,
        () -> recorder.report().stoppedBy().isPresent() || recorder.report().failure().isPresent(),
        () -> {
          RecorderReport report = recorder.finish();
          boolean jumped = report.stoppedBy().filter(Reset.class::isInstance).isPresent();
          return label(file, report.written()) + (jumped ? UNTIL_JUMP : "");
        });
  }

  /**
   * A recording of a camera, with the settings of camera and chain in its header; it continues in
   * another part when the camera's clock restarts.
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
            SessionRecorder.Limits.DEFAULT);
    return new RecordedFile(
        file,
        session,
        () ->
            session.endedEarly().isPresent()
                || session.parts().stream().anyMatch(part -> part.report().failure().isPresent()),
        () -> {
          List<SessionRecorder.Part> parts = session.finish();
          long events = parts.stream().mapToLong(part -> part.report().written()).sum();
          long lost = parts.stream().mapToLong(part -> part.report().lost()).sum();
          return label(file, events)
              + (parts.size() > 1 ? " in " + parts.size() + " parts" : "")
              + (parts.stream().anyMatch(part -> part.report().afterStop() > 0) ? UNTIL_JUMP : "")
              + (lost > 0 ? "; the disk was too slow for " + Texts.count(lost) : "")
              + session.endedEarly().map(line -> "; " + line).orElse("");
        });
  }

  private static String label(Path file, long events) {
    return "Recorded " + Texts.count(events) + " events to " + file.getFileName();
  }
}
