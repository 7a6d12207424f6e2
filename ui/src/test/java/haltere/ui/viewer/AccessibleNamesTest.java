package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.format.ReadOptions;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.cameras.CameraFeature;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ScrollBar;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextInputControl;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A screen reader has something to say of every control, in all panels, menus and dialogs. */
class AccessibleNamesTest {
  @TempDir Path folder;
  private ViewerHarness viewer;
  private final List<String> nameless = new ArrayList<>();
  private int controls;

  @AfterEach
  void close() {
    viewer.close();
  }

  private void run(String action) {
    viewer.run(() -> viewer.window.context().actions().run(action));
  }

  @Test
  void panelsOfARecordingHaveAccessibleNames() {
    List<String> filters =
        List.of("background-activity", "hot-pixels", "object-tracker", "cluster-tracker");
    viewer = ViewerHarness.withBlobAnd(filters.toArray(String[]::new));
    for (String name : filters) {
      viewer.fire("expand-" + name);
    }
    viewer.waitFor("the settings", () -> viewer.isThere("reset-all-cluster-tracker"));
    List.of("show-plots", "show-space-time", "show-live-flight", "compare").forEach(this::run);
    viewer.run(() -> viewer.window.context().panels().plots().addLane(PlotField.EVENT_RATE));
    TabPane side = viewer.node("side-tabs", TabPane.class);
    viewer.waitFor("the second chain", () -> side.getTabs().size() > 1);
    viewer.run(side.getSelectionModel()::selectFirst);
    assertAllAreNamed(150);
  }

  @Test
  void panelsOfWingsAndCamerasHaveAccessibleNames() {
    viewer = ViewerHarness.withBlob();
    run("open-scene");
    viewer.waitUntilOpen("Fly scene");
    run("show-wings");
    viewer.waitFor("a filter of a wing", () -> viewer.isThere("covariance-0-0"));
    assertAllAreNamed(60);
    viewer.run(() -> viewer.window.feature(CameraFeature.class).open("simulated:fly"));
    viewer.waitUntilOpen("simulated:fly");
    viewer.waitFor("its panel", () -> viewer.isThere("camera-bias-sets"));
    assertAllAreNamed(60);
  }

  @Test
  void menusAndDialogsHaveAccessibleNames() {
    viewer = ViewerHarness.withBlob();
    run("palette");
    viewer.waitFor("the palette", () -> viewer.isThere("palette-list"));
    assertAllAreNamed(30);
    closeAllButTheWindow();
    run("name-mark");
    viewer.waitFor("the question", () -> viewer.isThere("answer"));
    assertAllAreNamed(30);
    closeAllButTheWindow();
    run("keys");
    viewer.waitFor("the keys", () -> Window.getWindows().size() > 1);
    assertAllAreNamed(30);
    closeAllButTheWindow();
    viewer.run(
        () ->
            viewer
                .window
                .context()
                .sessions()
                .open(folder.resolve("missing.aedat"), ReadOptions.DEFAULT));
    viewer.waitFor("a problem", () -> viewer.text("status-message").contains("no such file"));
    viewer.fire("details");
    viewer.waitFor("its details", () -> viewer.isThere("problem-details"));
    assertAllAreNamed(30);
    closeAllButTheWindow();
    MenuButton add = viewer.node("add-filter", MenuButton.class);
    viewer.run(add::show);
    viewer.waitFor("filters to add", () -> viewer.isThere("add-filter-search"));
    assertAllAreNamed(30);
  }

  private void closeAllButTheWindow() {
    viewer.run(
        () ->
            List.copyOf(Window.getWindows()).stream()
                .filter(window -> window != viewer.stage)
                .forEach(Window::hide));
  }

  /** Waits for a number of controls, since the content of a tab comes with a later pulse. */
  private void assertAllAreNamed(int least) {
    viewer.waitFor(least + " controls", () -> collect() >= least);
    assertEquals(List.of(), nameless);
  }

  private int collect() {
    nameless.clear();
    controls = 0;
    List.copyOf(Window.getWindows()).forEach(window -> collect(window.getScene().getRoot()));
    return controls;
  }

  private void collect(Node node) {
    boolean isControl = node.isFocusTraversable() || node instanceof ButtonBase;
    if (isControl && !(node instanceof ScrollBar)) {
      controls++;
      if (!isNamed(node)) {
        nameless.add(node.getClass().getSimpleName() + " #" + node.getId());
      }
    }
    if (node instanceof Parent parent) {
      parent.getChildrenUnmodifiable().forEach(this::collect);
    }
  }

  private static boolean isNamed(Node node) {
    return hasWords(node.getAccessibleText())
        || node instanceof Labeled labeled && hasWords(labeled.getText())
        || node instanceof TextInputControl input && hasWords(input.getPromptText());
  }

  private static boolean hasWords(String text) {
    return text != null && text.matches(".*\\p{L}{2}.*");
  }
}
