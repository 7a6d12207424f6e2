package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.ProgressListener;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.playback.Loop;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.viewer.cameras.CameraFeature;
import haltere.ui.viewer.saving.ExportFeature;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Going back in what is no recording, in the real window. */
class BufferedMomentsTest {
  private static final String CAMERA = "simulated:fly";

  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private void open(String what) {
    if (what.equals(CAMERA)) {
      viewer = new ViewerHarness();
      viewer.run(() -> viewer.window.feature(CameraFeature.class).open(CAMERA));
      viewer.waitUntilOpen(CAMERA);
    } else {
      viewer = ViewerHarness.withBlob();
    }
  }

  private long elapsedUs() {
    return viewer.status().elapsedUs();
  }

  private void seek(long us) {
    viewer.run(() -> viewer.window.context().playback().seek(us));
    viewer.waitFor("there", () -> Math.abs(elapsedUs() - us) < 2000);
  }

  private String said() {
    return viewer.text("status-message");
  }

  private ExportFeature export() {
    return viewer.window.feature(ExportFeature.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a scene", CAMERA})
  void storedMomentsAreSteppedAndLoopedLikeARecording(String what) {
    open(what);
    viewer.waitFor("some time", () -> elapsedUs() > 800_000);
    viewer.pause();
    long newest = elapsedUs();
    viewer.press(KeyCode.COMMA);
    viewer.waitFor("a step back", () -> elapsedUs() < newest);
    seek(newest - 400_000);
    viewer.press(KeyCode.I);
    viewer.waitFor("in", () -> loop().inUs().isPresent());
    seek(newest - 200_000);
    viewer.press(KeyCode.O);
    viewer.waitFor("out", () -> loop().outUs().isPresent());
    viewer.press(KeyCode.R);
    viewer.waitFor("the start", () -> Math.abs(elapsedUs() - (newest - 400_000)) < 2000);
    viewer.press(KeyCode.SPACE);
    viewer.waitFor("it plays", () -> viewer.status().state() == State.PLAYING);
    viewer.waitFor("half of it", () -> elapsedUs() > newest - 300_000);
    viewer.waitFor("its start again", () -> elapsedUs() < newest - 300_000);
    assertTrue(elapsedUs() < newest - 190_000);
    viewer.press(KeyCode.END);
    viewer.waitFor("what is new", () -> elapsedUs() > newest + 50_000);
  }

  @Test
  void endShowsTheNewestEventsOfAPausedCamera() {
    open(CAMERA);
    viewer.waitFor("some time", () -> elapsedUs() > 300_000);
    viewer.pause();
    long pausedUs = elapsedUs();
    // a camera goes on in real time: a pause longer than the second of events that wait for its end
    long endNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(2500);
    viewer.waitFor("a long pause", () -> System.nanoTime() > endNanos);
    viewer.press(KeyCode.END);
    viewer.waitFor("the end of what is kept", () -> elapsedUs() > pausedUs + 500_000);
    viewer.waitFor("the end of the time bar", () -> viewer.text("remaining").isEmpty());
  }

  private Loop loop() {
    return viewer.onFx(() -> viewer.window.context().playback().loopProperty().get());
  }

  @Test
  void partOfASceneIsExportedAsFilmAndRecording() throws IOException {
    open("a scene");
    viewer.waitFor("some time", () -> elapsedUs() > 600_000);
    viewer.pause();
    long newest = elapsedUs();
    seek(newest - 400_000);
    viewer.press(KeyCode.I);
    seek(newest - 200_000);
    viewer.press(KeyCode.O);
    viewer.waitFor("a part", () -> loop().inUs().isPresent() && loop().outUs().isPresent());
    export("[56] pictures");
    RecordingSummary part = summary();
    long lengthUs = loop().outUs().getAsLong() - loop().inUs().getAsLong();
    assertTrue(part.events() > 500, part.events() + " events");
    assertEquals(lengthUs, part.lastUs() - part.firstUs(), 0.1 * lengthUs);
  }

  @Test
  void exportWithoutAMarkedPartContainsAllStoredMomentsOfACamera() throws IOException {
    open(CAMERA);
    viewer.waitFor("some events", () -> viewer.status().eventsIn() > 20_000);
    viewer.pause();
    export("\\d+ pictures?");
    RecordingSummary part = summary();
    assertTrue(part.events() > 5000, part.events() + " events");
    assertTrue(part.lastUs() >= viewer.status().timeUs());
  }

  private void export(String pictures) {
    viewer.run(() -> export().exportFilm(folder.resolve("part.gif")));
    viewer.waitFor("it says so", () -> said().matches("Exported part.gif: " + pictures));
    viewer.run(() -> export().exportData(folder.resolve("part.aedat4")));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.aedat4"));
  }

  private RecordingSummary summary() throws IOException {
    try (RecordingReader reader = Recordings.open(folder.resolve("part.aedat4"))) {
      return RecordingSummary.scan(reader, ProgressListener.NONE);
    }
  }
}
