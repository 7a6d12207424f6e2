package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.controls.FocusOrder;
import haltere.ui.viewer.picture.MeasuredLine;
import haltere.ui.viewer.picture.RegionMarks;
import haltere.ui.viewer.plots.PlotPanel;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javafx.collections.FXCollections;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TabPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Pane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The real window by keyboard only: nothing here touches a mouse. */
class KeyboardTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private Node focus() {
    return viewer.onFx(() -> viewer.stage.getScene().getFocusOwner());
  }

  /** As Tab would, only sooner. */
  private void goTo(String id) {
    viewer.waitFor("#" + id, () -> viewer.isThere(id));
    Node node = viewer.node(id, Node.class);
    viewer.run(node::requestFocus);
    viewer.waitFor("the focus on #" + id, node::isFocused);
  }

  private List<String> names() {
    return viewer.session().chain().stages().stream().map(ChainStage::name).toList();
  }

  private void openPanels(String... panels) {
    for (String panel : panels) {
      viewer.run(() -> viewer.window.context().actions().run(panel));
    }
  }

  @Test
  void tabReachesEveryControlWithoutATrap() {
    viewer = ViewerHarness.withBlob();
    openPanels("show-plots", "show-space-time", "show-live-flight", "compare", "show-camera");
    openPanels("show-wings");
    viewer.run(() -> viewer.window.context().panels().plots().addLane(PlotField.EVENT_RATE));
    walkWithTab();
    // another tab of the side
    goTo("side-tabs");
    TabPane tabs = viewer.node("side-tabs", TabPane.class);
    int before = viewer.onFx(() -> tabs.getSelectionModel().getSelectedIndex());
    viewer.press(KeyCode.LEFT);
    viewer.waitFor("another tab", () -> tabs.getSelectionModel().getSelectedIndex() == before - 1);
    walkWithTab();
  }

  private void walkWithTab() {
    viewer.pause();
    goTo("event-view");
    Set<Node> wanted =
        new LinkedHashSet<>(viewer.onFx(() -> FocusOrder.of(viewer.stage.getScene().getRoot())));
    assertTrue(wanted.size() > 30, wanted.size() + " controls");
    Node first = focus();
    Set<Node> seen = new LinkedHashSet<>();
    for (int i = 0; i < 2 * wanted.size() && seen.add(focus()); i++) {
      viewer.press(KeyCode.TAB);
    }
    assertEquals(first, focus(), "Tab comes back to where it began");
    wanted.removeAll(seen);
    assertEquals(Set.of(), wanted, "what Tab leaves out");
  }

  @Test
  void focusIsVisible() {
    viewer = ViewerHarness.withBlob();
    for (String id :
        List.of("play", "expand-object-tracker", "power-object-tracker", "more-object-tracker")) {
      goTo("mark");
      viewer.pause();
      Node node = viewer.node(id, Node.class);
      int without = viewer.onFx(() -> hash(node));
      goTo(id);
      viewer.press(KeyCode.SHIFT, KeyCode.TAB);
      viewer.press(KeyCode.TAB);
      viewer.waitFor("a ring around #" + id, () -> node.isFocused() && hash(node) != without);
    }
  }

  /** Of a control and a little around it. */
  private int hash(Node node) {
    var bounds = node.localToScene(node.getBoundsInLocal());
    var pixels = viewer.stage.getScene().snapshot(null).getPixelReader();
    int hash = 1;
    for (int y = (int) bounds.getMinY() - 3; y < bounds.getMaxY() + 3; y++) {
      for (int x = (int) bounds.getMinX() - 3; x < bounds.getMaxX() + 3; x++) {
        hash = 31 * hash + pixels.getArgb(x, y);
      }
    }
    return hash;
  }

  @Test
  void filterIsSearchedAddedMovedDisabledAndRemovedByKeys() {
    viewer = ViewerHarness.withBlob();
    List<String> before = names();
    double speed = viewer.onFx(() -> viewer.window.context().playback().speedProperty().get());
    goTo("add-filter");
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("the search", () -> viewer.isThere("add-filter-search"));
    Node search = viewer.node("add-filter-search", Node.class);
    viewer.waitFor("its focus", search::isFocused);
    viewer.type("refractory");
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("it is added", () -> names().contains("refractory"));
    assertEquals(
        speed,
        viewer.onFx(() -> viewer.window.context().playback().speedProperty().get()),
        "what is typed into a menu does nothing in the window");

    goTo("expand-refractory");
    viewer.press(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.UP);
    viewer.waitFor("one up", () -> names().indexOf("refractory") == before.size() - 1);
    viewer.waitFor("the focus goes along", () -> focus().getId().equals("expand-refractory"));
    viewer.press(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.DOWN);
    viewer.waitFor("one down", () -> names().indexOf("refractory") == before.size());
    viewer.press(KeyCode.TAB);
    viewer.press(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.UP);
    viewer.waitFor("up again", () -> names().indexOf("refractory") == before.size() - 1);
    viewer.waitFor("the mark goes along", () -> FocusOrder.isMarked(focus()));

    goTo("power-refractory");
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("off", () -> !viewer.session().chain().stage("refractory").isEnabled());

    goTo("more-refractory");
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("its menu", () -> viewer.isThere("remove-refractory"));
    viewer.press(KeyCode.UP);
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("it is gone", () -> names().equals(before));
  }

  /** A machine that is busy lays a window out later than a key is pressed. */
  @Test
  void enterOpensMenusAndListsBeforeTheirFirstLayout() {
    viewer = ViewerHarness.withBlob();
    MenuItem item = new MenuItem("Something");
    item.setId("item-of-a-menu");
    enterBeforeLayout(new MenuButton("Menu", null, item));
    viewer.waitFor("the menu", () -> viewer.isThere("item-of-a-menu"));
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("it is closed", () -> !viewer.isThere("item-of-a-menu"));
    enterBeforeLayout(new ChoiceBox<>(FXCollections.observableArrayList("this", "that")));
    viewer.waitFor("the list", () -> viewer.isThere("choice-box-menu-item"));
  }

  private void enterBeforeLayout(Control control) {
    viewer.run(
        () -> {
          ((Pane) viewer.window.context().panels().view().getParent()).getChildren().add(control);
          control.requestFocus();
          control.fireEvent(
              new KeyEvent(
                  KeyEvent.KEY_PRESSED, "", "", KeyCode.ENTER, false, false, false, false));
        });
  }

  @Test
  void toolsAreOperatedByArrowsAndEnter() {
    viewer = ViewerHarness.withBlob();
    InspectionFeature seeing = viewer.window.feature(InspectionFeature.class);
    goTo("event-view");
    viewer.press(KeyCode.T);
    drawToTheRight(3);
    viewer.waitFor("a length", () -> tapeWords().startsWith("3.0 px   0.0\u00b0"));
    viewer.press(KeyCode.G);
    drawToTheRight(4);
    viewer.waitFor(
        "a region of five pixels",
        () ->
            seeing.region().map(RegionMarks::region).filter(KeyboardTest::isFiveWide).isPresent());
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("no tool", () -> viewer.window.context().panels().view().tool().isEmpty());
    viewer.press(KeyCode.C);
    viewer.press(KeyCode.SHIFT, KeyCode.LEFT);
    viewer.waitFor(
        "the pixel at the cross",
        () ->
            viewer.node("cursor-readout", Label.class).isVisible()
                && viewer.text("cursor-readout").matches("x 5[34]   y 6[34].*"));
    viewer.press(KeyCode.C);
    viewer.waitFor("none", () -> !viewer.node("cursor-readout", Label.class).isVisible());
  }

  private String tapeWords() {
    var tape = viewer.window.context().display().tapeProperty().get();
    return tape.map(MeasuredLine::label).orElse("");
  }

  private static boolean isFiveWide(PixelRegion region) {
    return region.width() == 5 && region.height() == 1;
  }

  private void drawToTheRight(int pixels) {
    viewer.waitFor("a tool", () -> viewer.window.context().panels().view().tool().isPresent());
    viewer.press(KeyCode.ENTER);
    for (int i = 0; i < pixels; i++) {
      viewer.press(KeyCode.RIGHT);
    }
    viewer.press(KeyCode.ENTER);
  }

  @Test
  void laneIsReadScrolledAndUsedToSeekByKeys() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 3_000_000);
    openPanels("show-plots");
    viewer.run(() -> viewer.window.context().panels().plots().addLane(PlotField.EVENT_RATE));
    viewer.waitFor("a second", () -> viewer.status().elapsedUs() > 1_000_000);
    viewer.pause();
    Node lane = viewer.onFx(() -> viewer.window.context().panels().plots().lookup(".key-pane"));
    viewer.run(lane::requestFocus);
    PlotPanel plots = viewer.window.context().panels().plots();
    long spanUs = viewer.onFx(() -> plots.window().spanUs());
    viewer.press(KeyCode.EQUALS);
    viewer.waitFor("less time", () -> plots.window().spanUs() < spanUs);
    viewer.press(KeyCode.PAGE_UP);
    viewer.waitFor("earlier", () -> !plots.window().isFollowing());
    viewer.press(KeyCode.END);
    viewer.waitFor("the newest", () -> plots.window().isFollowing());
    long atUs = viewer.status().elapsedUs();
    viewer.press(KeyCode.SHIFT, KeyCode.LEFT);
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("playback there", () -> viewer.status().elapsedUs() < atUs);
  }

  @Test
  void f6MovesBetweenPanelsAndKeysResizeThem() {
    viewer = ViewerHarness.withBlob();
    openPanels("show-plots");
    goTo("event-view");
    viewer.press(KeyCode.F6);
    viewer.waitFor("the plots", () -> "add-plot".equals(focus().getId()));
    Node plots = focus();
    assertTrue(viewer.onFx(() -> FocusOrder.isMarked(plots)), "where the focus is");
    viewer.press(KeyCode.F6);
    viewer.waitFor("the chain", () -> "add-filter".equals(focus().getId()));
    assertFalse(viewer.onFx(() -> FocusOrder.isMarked(plots)), "where the focus was");
    viewer.press(KeyCode.SHIFT, KeyCode.F6);
    viewer.waitFor("the plots again", () -> "add-plot".equals(focus().getId()));
    double before = viewer.onFx(() -> viewer.window.context().panels().plots().getHeight());
    viewer.run(() -> viewer.window.context().actions().run("below-higher"));
    viewer.waitFor(
        "higher", () -> viewer.window.context().panels().plots().getHeight() > before + 10);
    assertFalse(viewer.onFx(() -> viewer.window.context().panels().plots().isFocused()));
  }

  @Test
  void f10AndArrowsMoveThroughMenus() throws IOException {
    viewer = ViewerHarness.withBlob();
    viewer.openRecording(ViewerHarness.recording(folder, "blob.aedat"));
    viewer.pause();
    viewer.run(() -> viewer.session().player().seek(0));
    viewer.waitFor("the start", () -> viewer.status().elapsedUs() == 0);
    goTo("event-view");
    MenuBar bar = viewer.node("menu", MenuBar.class);
    viewer.press(KeyCode.F10);
    viewer.press(KeyCode.RIGHT);
    viewer.press(KeyCode.DOWN);
    viewer.waitFor("the second menu", () -> bar.getMenus().get(1).isShowing());
    viewer.press(KeyCode.RIGHT);
    viewer.waitFor("the third menu", () -> bar.getMenus().get(2).isShowing());
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("no menu", () -> !bar.getMenus().get(2).isShowing());
    viewer.run(() -> viewer.window.context().actions().run("step-on"));
    viewer.waitFor("a step", () -> viewer.status().elapsedUs() > 0);
    assertEquals(0, viewer.status().elapsedUs(), 900_000, "playback did not jump by a second");
  }
}
