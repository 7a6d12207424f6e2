package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.format.ReadOptions;
import haltere.core.json.internal.Json;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.FutureTask;
import javafx.event.ActionEvent;
import javafx.geometry.Rectangle2D;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.TextField;
import javafx.scene.control.TextInputControl;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.stage.Screen;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How the window treats a person: what it keeps, takes back, and calls things. */
class MannersTest {
  private static final String NOISE = "background-activity";
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    if (viewer != null) {
      viewer.close();
    }
  }

  @Test
  void windowIsRestored() throws IOException {
    Path recording = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(recording, 500_000);
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    viewer.run(
        () ->
            viewer
                .window
                .context()
                .sessions()
                .open(SessionRequest.recording(recording, ReadOptions.DEFAULT)));
    viewer.waitUntilOpen("blob.aedat");
    viewer.run(
        () -> {
          viewer.window.context().display().themeProperty().set(Theme.LIGHT);
          viewer.window.context().display().modeProperty().set(DisplayMode.COUNTS);
          viewer.window.context().actions().run("show-space-time");
        });
    viewer.waitFor("it is saved", () -> Files.exists(folder.resolve("viewer.json")));
    viewer.waitFor("all of it", () -> !settings.hasChanged());
    viewer.close();

    Map<?, ?> kept = (Map<?, ?>) Json.read(folder.resolve("viewer.json"));
    assertEquals("Light", kept.get("theme"));
    assertEquals("Event count", kept.get("showAs"));
    assertEquals(List.of(recording.toString()), kept.get("recentFiles"));
    viewer = new ViewerHarness(UserSettings.load(folder));
    assertEquals(
        Theme.LIGHT, viewer.onFx(() -> viewer.window.context().display().themeProperty().get()));
    assertEquals(
        DisplayMode.COUNTS,
        viewer.onFx(() -> viewer.window.context().display().modeProperty().get()));
    viewer.waitFor("the panel", () -> viewer.isThere("space-time"));
    viewer.press(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.O);
    viewer.waitUntilOpen("blob.aedat");
    viewer.run(() -> viewer.window.context().display().themeProperty().set(Theme.DARK));
  }

  @Test
  void unusableSettingsAreIgnored() throws IOException {
    Files.writeString(
        folder.resolve("viewer.json"),
        "{\"theme\": 7, \"showAs\": \"Nonsense\", \"window\": [], \"later\": \"kept\"}");
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    assertEquals(
        DisplayMode.POLARITY,
        viewer.onFx(() -> viewer.window.context().display().modeProperty().get()));
    viewer.run(() -> viewer.window.context().display().modeProperty().set(DisplayMode.ON_ONLY));
    settings.save();
    Map<?, ?> kept = (Map<?, ?>) Json.read(folder.resolve("viewer.json"));
    assertEquals("kept", kept.get("later"));
    assertEquals("ON only", kept.get("showAs"));
    Files.writeString(folder.resolve("viewer.json"), "{ this is no JSON");
    assertEquals(true, UserSettings.load(folder).get("theme").isEmpty());
  }

  @Test
  void changesOfSettingsAndChainAreUndone() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    viewer.click("expand-" + NOISE);
    enter("entry-" + NOISE + "-neighbours", "3");
    viewer.waitFor("three", () -> text("entry-" + NOISE + "-neighbours").equals("3"));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("one again", () -> text("entry-" + NOISE + "-neighbours").equals("1"));
    viewer.run(() -> viewer.window.context().actions().run("redo"));
    viewer.waitFor("three again", () -> text("entry-" + NOISE + "-neighbours").equals("3"));
    List<String> before = names();
    viewer.click("more-hot-pixels");
    viewer.click("remove-hot-pixels");
    viewer.waitFor("it is gone", () -> !names().equals(before));
    viewer.waitFor("its card is gone", () -> !viewer.isThere("stage-hot-pixels"));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("it is back", () -> names().equals(before));
    viewer.waitFor("its card is back", () -> viewer.isThere("stage-hot-pixels"));
  }

  @Test
  void settingsAreSearchedAndFilteredByChanges() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    enter("settings-search", "same polarity");
    viewer.waitFor("it is found", () -> isSeen("check-" + NOISE + "-samePolarity"));
    assertFalse(isSeen("entry-" + NOISE + "-neighbours"));
    assertFalse(isSeen("settings-none"));
    enter("settings-search", "no such thing");
    viewer.waitFor("that there is none", () -> isSeen("settings-none"));
    enter("settings-search", "neighbours");
    viewer.waitFor("another", () -> isSeen("entry-" + NOISE + "-neighbours"));
    enter("entry-" + NOISE + "-neighbours", "2");
    enter("settings-search", "");
    viewer.waitFor("all cards", () -> isSeen("stage-hot-pixels"));
    ToggleButton changed = viewer.node("changed-only", ToggleButton.class);
    viewer.run(() -> changed.setSelected(true));
    viewer.waitFor("what was changed", () -> isSeen("entry-" + NOISE + "-neighbours"));
    assertFalse(isSeen("entry-" + NOISE + "-correlationUs"));
    assertFalse(isSeen("stage-hot-pixels"));
  }

  @Test
  void filterIsSearchedByDescriptionAndAddedByEnter() {
    viewer = ViewerHarness.withBlob();
    viewer.click("add-filter");
    viewer.waitFor("the search", () -> viewer.isThere("add-filter-search"));
    TextField search = viewer.node("add-filter-search", TextField.class);
    viewer.run(() -> search.setText("refractory"));
    viewer.run(() -> search.fireEvent(new ActionEvent()));
    viewer.waitFor("it is added", () -> names().contains("refractory"));
  }

  @Test
  void lettersSearchFiltersAlsoWhenTheMouseIsOverAFilter() {
    viewer = ViewerHarness.withBlob();
    viewer.click("add-filter");
    viewer.waitFor("the search", () -> viewer.isThere("add-filter-search"));
    viewer.run(viewer.node("add-hot-pixels", Node.class)::requestFocus);
    viewer.type("road");
    TextField search = viewer.node("add-filter-search", TextField.class);
    viewer.waitFor("the word", () -> search.getText().equals("road"));
    viewer.waitFor("the match", () -> !viewer.isThere("add-hot-pixels"));
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("it is added", () -> names().contains("kalman-tracks"));
  }

  @Test
  void windowBesideTheViewerIsNoLargerThanTheScreen() {
    viewer = ViewerHarness.withBlob();
    Scene scene =
        viewer.onFx(
            () -> Windows.beside(viewer.stage, "Plots", new Group(), 9000, 9000).getScene());
    Rectangle2D room = viewer.onFx(() -> Screen.getPrimary().getVisualBounds());
    assertEquals(room.getWidth(), scene.getWidth());
    assertEquals(room.getHeight(), scene.getHeight());
  }

  @Test
  void problemIsOneLineWithDetailsOnAClick() {
    viewer = ViewerHarness.withBlob();
    viewer.run(
        () ->
            viewer
                .window
                .context()
                .sessions()
                .open(folder.resolve("missing.aedat"), ReadOptions.DEFAULT));
    viewer.waitFor("the line", () -> viewer.text("status-message").contains("no such file"));
    viewer.click("details");
    viewer.waitFor("the details", () -> viewer.isThere("problem-details"));
    TextInputControl details = viewer.node("problem-details", TextInputControl.class);
    assertTrue(viewer.onFx(details::getText).contains("RecordingProblem"));
    viewer.run(() -> details.getScene().getWindow().hide());
  }

  @Test
  void lineThatIsCutOffIsReadInFull() {
    viewer = ViewerHarness.withBlob();
    String line = "no room; ".repeat(60);
    viewer.run(() -> viewer.window.context().status().showError(line));
    viewer.click("details");
    viewer.waitFor("the details", () -> viewer.isThere("problem-details"));
    TextInputControl details = viewer.node("problem-details", TextInputControl.class);
    assertEquals(line, viewer.onFx(details::getText));
    viewer.run(() -> details.getScene().getWindow().hide());
  }

  @Test
  void unreadableRecordingIsReportedInItsWindow() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    FutureTask<ViewerSession> first =
        new FutureTask<>(
            () ->
                SessionRequest.recording(empty, ReadOptions.DEFAULT)
                    .firstSession(java.util.Optional.empty()));
    first.run();
    viewer = new ViewerHarness();
    viewer.run(() -> viewer.window.context().sessions().open(first, empty.toString()));
    viewer.waitFor(
        "the line", () -> viewer.text("status-message").startsWith(empty + ": the file is empty"));
  }

  private boolean isSeen(String id) {
    if (!viewer.isThere(id)) {
      return false;
    }
    Node node = viewer.node(id, Node.class);
    return viewer.onFx(
        () -> {
          for (Node above = node; above != null; above = above.getParent()) {
            if (!above.isVisible()) {
              return false;
            }
          }
          return true;
        });
  }

  private String text(String id) {
    TextField field = viewer.node(id, TextField.class);
    return viewer.onFx(field::getText);
  }

  private void enter(String id, String text) {
    TextField field = viewer.node(id, TextField.class);
    viewer.run(
        () -> {
          field.setText(text);
          field.fireEvent(new ActionEvent());
        });
  }

  private List<String> names() {
    return viewer.session().chain().stages().stream().map(ChainStage::name).toList();
  }
}
