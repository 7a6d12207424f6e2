package haltere.ui.viewer.saving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.format.ProgressListener;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Recorder;
import haltere.core.playback.ScenePlayable;
import haltere.ui.viewer.BlobSource;
import haltere.ui.viewer.ViewerHarness;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javafx.scene.control.Label;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Recording while it plays, in the real window. */
class RecordedFileTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private boolean recording() {
    var actions = viewer.window.context().actions();
    return viewer.onFx(() -> actions.find("record").orElseThrow().on().orElseThrow().get());
  }

  private String said() {
    return viewer.onFx(() -> ((Label) viewer.stage.getScene().lookup("#status-message")).getText());
  }

  private static RecordingSummary summary(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      return RecordingSummary.scan(reader, ProgressListener.NONE);
    }
  }

  @Test
  void playbackIsRecordedUntilStopped() throws IOException {
    viewer = ViewerHarness.withBlob();
    Path file = folder.resolve("out.aedat4");
    viewer.run(() -> viewer.window.feature(SavingFeature.class).record(file));
    assertTrue(recording());
    viewer.waitFor("it says so", () -> said().equals("Recording to out.aedat4"));
    long fromUs = viewer.status().timeUs();
    viewer.waitFor("half a second", () -> viewer.status().timeUs() > fromUs + 500_000);
    viewer.run(() -> viewer.window.feature(SavingFeature.class).toggleRecording());
    assertFalse(recording());
    viewer.waitFor("it says what was recorded", () -> said().startsWith("Recorded "));
    RecordingSummary summary = summary(file);
    assertEquals(BlobSource.GEOMETRY.width(), summary.geometry().width());
    assertTrue(summary.lastUs() - summary.firstUs() >= 450_000, summary.durationS() + " s");
    assertTrue(summary.warnings().isEmpty(), () -> summary.warnings().toString());
  }

  @Test
  void seekEndsTheRecording() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 4_000_000);
    Path file = folder.resolve("out.aedat4");
    viewer.run(() -> viewer.window.feature(SavingFeature.class).record(file));
    viewer.waitFor("it records", () -> said().startsWith("Recording to"));
    long fromUs = viewer.status().timeUs();
    viewer.waitFor("some time", () -> viewer.status().timeUs() > fromUs + 100_000);
    viewer.run(() -> viewer.window.context().playback().seek(0));
    viewer.waitFor("it ends", () -> !recording());
    viewer.waitFor("it says why", () -> said().endsWith("out.aedat4, until playback jumped"));
    assertTrue(summary(file).events() > 0);
  }

  @Test
  void openingAnotherRecordingEndsTheCurrentOne() throws IOException {
    viewer = ViewerHarness.withBlob();
    Path file = folder.resolve("out.aedat4");
    viewer.run(() -> viewer.window.feature(SavingFeature.class).record(file));
    viewer.waitFor("it records", () -> said().startsWith("Recording to"));
    long fromUs = viewer.status().timeUs();
    viewer.waitFor("some time", () -> viewer.status().timeUs() > fromUs + 200_000);
    viewer.open(() -> new ScenePlayable(() -> new BlobSource(1_000_000), "next"));
    viewer.waitFor("it ends", () -> !recording());
    viewer.waitFor(
        "the file is whole",
        () -> Files.exists(file) && said().isEmpty() || said().startsWith("Recorded "));
    assertTrue(summary(file).events() > 0);
  }

  @Test
  void openRecordingIsNotReplaced() throws IOException {
    Path file = ViewerHarness.recording(folder, "blob.aedat4");
    long bytes = Files.size(file);
    viewer = new ViewerHarness();
    viewer.openRecording(file);
    viewer.run(() -> viewer.window.feature(SavingFeature.class).record(file));
    viewer.waitFor("the refusal", () -> said().contains("blob.aedat4 is open; choose another"));
    viewer.waitFor("nothing is recorded", () -> !recording());
    assertEquals(bytes, Files.size(file));
  }

  /** A disk that is full from the first packet on. */
  private static final class FullDisk implements RecordingWriter {
    @Override
    public void write(EventPacket packet) throws IOException {
      throw new IOException("No space left on device");
    }

    @Override
    public void finish() {}

    @Override
    public void close() {}
  }

  @Test
  void fullDiskEndsTheRecordingAndIsReported() {
    viewer = ViewerHarness.withBlob();
    Recorder recorder =
        new Recorder(new FullDisk(), BlobSource.GEOMETRY, OverflowPolicy.DROP_NEWEST);
    RecordedFile full = RecordedFile.of(folder.resolve("out.aedat4"), recorder);
    viewer.run(() -> viewer.window.feature(SavingFeature.class).record(open -> full));
    viewer.waitFor("it ends", () -> full.isOver() && !recording());
    viewer.waitFor(
        "it says why",
        () -> said().contains("the recording could not be written: No space left on device"));
    assertFalse(said().contains("Exception"), said());
  }

  @Test
  void unwritableFileIsReportedInOneLine() {
    viewer = ViewerHarness.withBlob();
    viewer.run(
        () ->
            viewer
                .window
                .feature(SavingFeature.class)
                .record(folder.resolve("no").resolve("out.aedat4")));
    viewer.waitFor("the problem", () -> said().contains("out.aedat4"));
    viewer.waitFor("nothing is recorded", () -> !recording());
  }
}
