package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.ui.viewer.feature.UserSettings;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Pane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the file says of itself, what is wrong with it, and which camera made it. */
class FileInfoTest {
  @TempDir Path folder;
  private UserSettings settings;
  private ViewerHarness viewer;

  @BeforeEach
  void openWindow() {
    settings = UserSettings.load(folder.resolve("settings"));
    viewer = new ViewerHarness(settings);
    viewer.run(() -> viewer.window.context().actions().run("show-file-information"));
    viewer.waitFor("the panel", () -> viewer.isThere("file-info"));
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private Optional<String> line(String name) {
    ScrollPane panel = viewer.node("file-info", ScrollPane.class);
    return viewer.onFx(
        () ->
            ((Pane) panel.getContent())
                .getChildren().stream()
                    .map(Label.class::cast)
                    .filter(label -> label.getText().equals(name) && label.getLabelFor() != null)
                    .map(label -> ((Label) label.getLabelFor()).getText())
                    .findFirst());
  }

  private boolean seesBanner() {
    return viewer.isThere("warnings");
  }

  /** Events in the corner of a sensor of a size that the file does not state. */
  private Path withoutSensor() throws IOException {
    StringBuilder rows = new StringBuilder("timestamp,x,y,polarity\n");
    for (int i = 0; i < 40_000; i++) {
      rows.append(i * 50L).append(',').append(i % 200).append(',').append(i % 150).append(",1\n");
    }
    return Files.write(
        folder.resolve("nameless.csv"), rows.toString().getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void panelShowsFormatSensorCountsTimesAndRates() throws IOException {
    Path file = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(file, 1_000_000);
    viewer.openRecording(file);
    viewer.waitFor("facts", () -> line("Events").isPresent());
    assertEquals(Optional.of("20,000 (10,000 ON, 10,000 OFF)"), line("Events"));
    assertEquals(Optional.of("aedat2"), line("Format"));
    assertTrue(line("Sensor").orElseThrow().startsWith("128 \u00d7 128"));
    assertEquals(Optional.of("0.999950 s"), line("Duration"));
    assertTrue(line("Mean rate").orElseThrow().startsWith("20.0"));
    assertEquals(Optional.of("0"), line("Frames"));
    assertEquals(Optional.of("none"), line("Warnings"));
    assertFalse(seesBanner());
  }

  @Test
  void truncatedFileHasABannerThatIsDismissed() throws IOException {
    Path whole = folder.resolve("whole.aedat4");
    ViewerHarness.writeRecording(whole, 1_000_000);
    byte[] bytes = Files.readAllBytes(whole);
    Path cut = folder.resolve("cut.aedat4");
    Files.write(cut, Arrays.copyOf(bytes, bytes.length * 2 / 3));
    viewer.openRecording(cut);
    viewer.waitFor("the compression", () -> line("Compression").equals(Optional.of("lz4")));
    viewer.waitFor("the banner", this::seesBanner);
    viewer.waitFor("the words", () -> viewer.text("warning-first").contains("ends in the middle"));
    viewer.click("warnings-dismiss");
    viewer.waitFor("no banner", () -> !seesBanner());
  }

  private static <T> String label(ChoiceBox<T> box) {
    return box.getConverter().toString(box.getValue());
  }

  @Test
  void unknownCameraIsRequestedWithTheGuessFirstAndStored() throws IOException {
    Path file = withoutSensor();
    viewer.openRecording(file);
    viewer.waitFor("the question", () -> viewer.isThere("camera-use"));
    ChoiceBox<?> sizes = viewer.node("camera-choice", ChoiceBox.class);
    viewer.waitFor("choices", () -> viewer.onFx(() -> sizes.getItems().size()) > 3);
    assertTrue(viewer.onFx(() -> label(sizes)).startsWith("240 \u00d7 180"));
    viewer.run(() -> sizes.getSelectionModel().select(5));
    viewer.waitFor("the choice", () -> label(sizes).startsWith("640"));
    viewer.click("camera-use");
    viewer.waitFor(
        "the larger sensor", () -> viewer.session().player().playable().geometry().width() == 640);
    Optional<String> said = Optional.of("640 \u00d7 480, rows from the top");
    viewer.waitFor("facts", () -> line("Sensor").equals(said));
    viewer.close();
    settings.save();
    viewer = new ViewerHarness(UserSettings.load(folder.resolve("settings")));
    viewer.openRecording(file);
    assertEquals(640, viewer.session().player().playable().geometry().width());
  }

  @Test
  void statedSensorSizeSuppressesTheCameraQuestion() throws IOException {
    Path file = withoutSensor();
    SensorGeometry said = new SensorGeometry(346, 260);
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSensor(said))) {
      assertEquals(346, reader.geometry().width());
    }
    viewer.run(
        () -> viewer.window.context().sessions().open(file, ReadOptions.DEFAULT.withSensor(said)));
    viewer.waitUntilOpen("nameless.csv");
    viewer.waitFor("facts", () -> line("Sensor").isPresent());
    assertFalse(line("Sensor").orElseThrow().contains("guessed"));
  }
}
