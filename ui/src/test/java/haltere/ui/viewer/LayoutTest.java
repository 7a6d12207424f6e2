package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.compare.CompareFeature;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.saving.SavingFeature;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonType;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.SplitPane;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import javafx.stage.Popup;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Panels that are kept under a name, and plots in a window of their own. */
class LayoutTest {
  /** What lies between the events and the side at most. */
  private static final double DIVIDER_PX = 10;

  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private void run(String action) {
    viewer.run(() -> viewer.window.context().actions().run(action));
  }

  private boolean isInWindow(String id) {
    return viewer.onFx(() -> viewer.stage.getScene().lookup("#" + id) != null);
  }

  @Test
  void layoutIsStoredSelectedRemovedAndRestoredAfterARestart() throws Exception {
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    run("show-plots");
    run("show-file-information");
    viewer.waitFor("panels", () -> isInWindow("plots") && isInWindow("file-info"));
    viewer.run(() -> viewer.window.feature(LayoutFeature.class).keep("Wings"));
    run("picture-alone");
    viewer.waitFor("the picture alone", () -> !isInWindow("plots") && !isInWindow("file-info"));
    run("layout-Wings");
    viewer.waitFor("the panels again", () -> isInWindow("plots") && isInWindow("file-info"));
    settings.save();
    viewer.close();
    viewer = new ViewerHarness(UserSettings.load(folder));
    run("picture-alone");
    run("layout-Wings");
    viewer.waitFor("the panels of before", () -> isInWindow("plots") && isInWindow("file-info"));
    run("remove-layout-Wings");
    assertEquals(
        Optional.empty(),
        viewer.onFx(() -> viewer.window.context().actions().find("layout-Wings")));
  }

  @Test
  void usedNameIsReplacedOnlyIfThatIsConfirmed() {
    viewer = ViewerHarness.withBlob();
    viewer.run(() -> viewer.window.feature(LayoutFeature.class).keep("Mine"));
    run("show-plots");
    saveAs("Mine");
    answer("Replace Mine?", ButtonType.CANCEL);
    assertEquals(false, hasPlots("Mine"));
    saveAs("Mine");
    answer("Replace Mine?", ButtonType.OK);
    assertEquals(true, hasPlots("Mine"));
    saveAs("Yours");
    assertEquals(true, hasPlots("Yours"));
  }

  private Object hasPlots(String layout) {
    UserSettings settings = viewer.window.context().settings();
    return viewer.onFx(() -> ((Map<?, ?>) settings.map("layouts").get(layout)).get("panel.plots"));
  }

  /** The start with such a layout failed, as the name was that of a command too. */
  @Test
  void layoutMayBeNamedAsACommandOfItsMenu() throws Exception {
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    run("show-plots");
    viewer.run(() -> viewer.window.feature(LayoutFeature.class).keep("picture"));
    settings.save();
    viewer.close();
    viewer = new ViewerHarness(UserSettings.load(folder));
    run("picture-alone");
    viewer.waitFor("the picture alone", () -> !isInWindow("plots"));
    run("layout-picture");
    viewer.waitFor("the layout of this name", () -> isInWindow("plots"));
  }

  private void saveAs(String name) {
    run("keep-layout");
    viewer.waitFor("the name", () -> viewer.isThere("answer"));
    viewer.run(() -> viewer.node("answer", TextField.class).setText(name));
    answer("Name of the layout", ButtonType.OK);
  }

  private void answer(String question, ButtonType button) {
    viewer.waitFor(question, () -> dialog(question).isPresent());
    viewer.run(() -> ((Button) dialog(question).get().lookupButton(button)).fire());
  }

  private static Optional<DialogPane> dialog(String question) {
    return Window.getWindows().stream()
        .map(window -> window.getScene().getRoot())
        .filter(DialogPane.class::isInstance)
        .map(DialogPane.class::cast)
        .filter(pane -> question.equals(pane.getContentText()))
        .findFirst();
  }

  @Test
  void plotIsAddedByACommand() {
    viewer = ViewerHarness.withBlob();
    run("add-plot");
    MenuButton add = viewer.node("add-plot", MenuButton.class);
    viewer.waitFor("the menu", () -> isInWindow("plots") && add.isShowing());
    viewer.run(add::hide);
    run("plots-apart");
    viewer.waitFor("plots elsewhere", () -> viewer.isThere("plots") && !isInWindow("plots"));
    run("add-plot");
    viewer.waitFor("the menu there", () -> !isInWindow("plots") && add.isShowing());
    viewer.run(add::hide);
  }

  @Test
  void pictureAloneHidesTheWindowOfThePlotsAndShowsItAgain() {
    viewer = ViewerHarness.withBlob();
    run("plots-apart");
    viewer.waitFor("plots elsewhere", () -> viewer.isThere("plots") && !isInWindow("plots"));
    run("picture-alone");
    viewer.waitFor("the picture alone", () -> !viewer.isThere("plots"));
    run("picture-alone");
    viewer.waitFor("their window", () -> viewer.isThere("plots") && !isInWindow("plots"));
  }

  @Test
  void pictureAloneRestoresTheOrderOfTheTabsAndTheSelectedOne() {
    viewer = ViewerHarness.withBlob();
    run("show-wings");
    run("show-file-information");
    run("compare");
    viewer.waitFor("the panels", () -> tabs().size() == 4);
    List<String> order = tabs();
    for (int selected = 0; selected < order.size(); selected++) {
      int tab = selected;
      viewer.run(() -> side().getSelectionModel().select(tab));
      run("picture-alone");
      viewer.waitFor("no panels", () -> !isInWindow("side-tabs"));
      run("picture-alone");
      viewer.waitFor("the panels", () -> isInWindow("side-tabs"));
      viewer.waitFor("the panels in order", () -> tabs().equals(order));
      assertEquals(tab, viewer.onFx(() -> side().getSelectionModel().getSelectedIndex()));
    }
  }

  @Test
  void pictureAloneHidesAComparisonWhichGoesOn() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    run("compare");
    viewer.waitFor("both pictures", () -> isInWindow("second-event-view") && secondChain() != null);
    FilterChain second = secondChain();
    double half = viewer.onFx(() -> viewer.node("event-view", Region.class).getWidth());
    run("picture-alone");
    viewer.waitFor(
        "the picture alone",
        () -> !isInWindow("second-event-view") && !viewer.isThere("first-chain-name"));
    viewer.waitFor(
        "its width", () -> viewer.node("event-view", Region.class).getWidth() > 1.5 * half);
    run("picture-alone");
    viewer.waitFor("the comparison", () -> isInWindow("second-event-view"));
    viewer.waitFor("its name", () -> viewer.isThere("first-chain-name"));
    assertSame(second, secondChain());
    run("picture-alone");
    run("compare");
    run("picture-alone");
    viewer.waitFor("no ended comparison", () -> !isInWindow("second-event-view"));
  }

  private FilterChain secondChain() {
    return viewer.onFx(
        () -> viewer.window.feature(CompareFeature.class).secondChain().orElse(null));
  }

  @Test
  void pictureAloneShowsTheSelectedChainAgain() {
    viewer = ViewerHarness.withBlob();
    run("show-file-information");
    viewer.waitFor("the panel", () -> tabs().size() == 2);
    viewer.run(() -> side().getSelectionModel().select(0));
    run("picture-alone");
    viewer.waitFor("the chain alone", () -> !isInWindow("side-tabs") && isInWindow("chain-panel"));
    run("picture-alone");
    viewer.waitFor("the tabs", () -> isInWindow("side-tabs"));
    assertEquals(0, viewer.onFx(() -> side().getSelectionModel().getSelectedIndex()));
    assertTrue(isInWindow("chain-panel"));
  }

  private TabPane side() {
    return viewer.node("side-tabs", TabPane.class);
  }

  private List<String> tabs() {
    return viewer.onFx(() -> side().getTabs().stream().map(Tab::getText).toList());
  }

  @Test
  void layoutStoresThePlottedFields() throws Exception {
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    PlotField x = new PlotField("object-tracker", "objects", "x_px");
    List<List<PlotField>> lanes = List.of(List.of(PlotField.EVENT_RATE, x), List.of(x));
    viewer.run(() -> viewer.window.context().panels().plots().fieldsProperty().set(lanes));
    viewer.run(() -> viewer.window.feature(LayoutFeature.class).keep("positions"));
    viewer.run(() -> viewer.window.context().panels().plots().fieldsProperty().set(List.of()));
    settings.save();
    viewer.close();
    viewer = new ViewerHarness(UserSettings.load(folder));
    assertEquals(List.of(), plotted());
    run("layout-positions");
    viewer.waitFor("the same lanes", () -> plotted().equals(lanes));
  }

  private List<List<PlotField>> plotted() {
    return viewer.onFx(
        () -> viewer.window.context().panels().plots().lanes().stream().map(Lane::fields).toList());
  }

  @Test
  void layoutStoresTheSizesOfItsPanels() {
    viewer = new ViewerHarness();
    run("show-plots");
    viewer.waitFor("plots", () -> isInWindow("plots"));
    SplitPane pane = viewer.onFx(() -> splitPaneOf(viewer.node("plots", Node.class)));
    viewer.run(() -> pane.setDividerPosition(0, 0.4));
    viewer.run(() -> viewer.window.feature(LayoutFeature.class).keep("low"));
    viewer.run(() -> pane.setDividerPosition(0, 0.7));
    run("layout-low");
    viewer.waitFor(
        "the size of before", () -> Math.abs(pane.getDividerPositions()[0] - 0.4) < 0.01);
  }

  @Test
  void sidePanelKeepsItsWidthInAWiderWindow() throws Exception {
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    run("side-wider");
    viewer.waitFor("a wider side", () -> Math.abs(sideWidth() - keptSide(settings)) < DIVIDER_PX);
    double width = sideWidth();
    double window = viewer.onFx(() -> viewer.stage.getScene().getWidth()) - 200;
    viewer.run(() -> viewer.stage.setWidth(viewer.stage.getWidth() - 200));
    viewer.waitFor(
        "the narrower window",
        () ->
            viewer.onFx(() -> viewer.stage.getScene().getWidth()) <= window
                && Math.abs(sideWidth() - width) < 2);
    settings.save();
    viewer.close();
    viewer = new ViewerHarness(UserSettings.load(folder));
    viewer.waitFor("the side of before", () -> Math.abs(sideWidth() - width) < 2);
  }

  @Test
  void verySmallWindowDoesNotChangeTheSizesOfPanels() {
    viewer = new ViewerHarness();
    run("open-scene");
    viewer.waitUntilOpen("Fly scene");
    viewer.waitFor("plots", () -> isInWindow("plots"));
    run("show-space-time");
    run("compare");
    viewer.run(() -> viewer.stage.setWidth(1200));
    viewer.waitFor("the second picture", () -> isInWindow("second-event-view"));
    viewer.waitFor("the side", () -> isInWindow("side-tabs") && width("side-tabs") > 300);
    SplitPane below = viewer.onFx(() -> splitPaneOf(viewer.node("plots", Node.class)));
    double side = width("side-tabs");
    double share = viewer.onFx(() -> below.getDividerPositions()[0]);
    double width = viewer.onFx(viewer.stage::getWidth);
    double height = viewer.onFx(viewer.stage::getHeight);
    viewer.run(() -> setSize(ViewerWindow.MIN_WIDTH, ViewerWindow.MIN_HEIGHT));
    viewer.waitFor("the narrow side", () -> width("side-tabs") < side - 20);
    viewer.waitFor("the bottom line", () -> isWithinHeight("status-line"));
    viewer.run(() -> setSize(width, height));
    viewer.waitFor("the side of before", () -> Math.abs(width("side-tabs") - side) < 2);
    viewer.waitFor(
        "the plots of before", () -> Math.abs(below.getDividerPositions()[0] - share) < 0.01);
  }

  @Test
  void leastSizeThatAWindowManagerGivesToANewWindowIsNotStored() {
    UserSettings settings = UserSettings.inMemory();
    viewer = new ViewerHarness(settings);
    viewer.run(() -> setSize(900, 600));
    viewer.waitFor("the size", () -> keptWidth(settings) == 900);
    viewer.run(() -> setSize(ViewerWindow.MIN_WIDTH, ViewerWindow.MIN_HEIGHT));
    viewer.waitFor("the least size", () -> viewer.stage.getHeight() == ViewerWindow.MIN_HEIGHT);
    // after what the window does later
    viewer.run(() -> {});
    assertEquals(900, keptWidth(settings));
  }

  private double keptWidth(UserSettings settings) {
    return viewer.onFx(
        () -> settings.map("window").get("width") instanceof Number width ? width.intValue() : 0);
  }

  private void setSize(double width, double height) {
    viewer.stage.setWidth(width);
    viewer.stage.setHeight(height);
  }

  private boolean isWithinHeight(String id) {
    return bottom(id) <= viewer.onFx(() -> viewer.stage.getScene().getHeight()) + 1;
  }

  private double keptSide(UserSettings settings) {
    return viewer.onFx(() -> settings.get("share.side").map(size -> (Double) size).orElse(0.0));
  }

  private double sideWidth() {
    return width("chain-panel");
  }

  private double width(String id) {
    return viewer.onFx(() -> viewer.node(id, Region.class).getWidth());
  }

  @Test
  void smallWindowShowsAllPanels() throws Exception {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.run(
        () -> {
          viewer.stage.setWidth(ViewerWindow.MIN_WIDTH);
          viewer.stage.setHeight(ViewerWindow.MIN_HEIGHT);
        });
    run("show-file-information");
    viewer.waitFor("the side", () -> isInWindow("file-info"));
    for (String id : List.of("event-view", "side-tabs", "seek-bar", "elapsed", "status-line")) {
      viewer.waitFor(id + " is within the window", () -> isWithinWindow(id));
    }
  }

  @Test
  void sizeOfARecordingIsNamedInFullInASmallWindow() {
    viewer = ViewerHarness.withBlob();
    viewer.run(() -> setSize(840, 700));
    SavingFeature saving = viewer.window.feature(SavingFeature.class);
    viewer.run(() -> saving.record(folder.resolve("out.aedat4")));
    Label numbers = viewer.node("record-numbers", Label.class);
    viewer.waitFor("its size", () -> numbers.getText().endsWith("B"));
    viewer.waitFor("all of it", () -> numbers.getWidth() >= numbers.prefWidth(-1));
    viewer.waitFor("the elapsed time beside it", () -> isWithinWindow("elapsed"));
    viewer.run(() -> setSize(ViewerWindow.MIN_WIDTH, ViewerWindow.MIN_HEIGHT));
    viewer.waitFor("the elapsed time in a tiny window", () -> isWithinWindow("elapsed"));
  }

  @Test
  void pauseIsNamedInFullBesideALongFileName() throws Exception {
    Path file = folder.resolve("a-rather-long-name-of-a-recording-2026.aedat4");
    ViewerHarness.writeRecording(file, 2_000_000);
    viewer = new ViewerHarness();
    viewer.run(() -> viewer.stage.setWidth(1024));
    viewer.openRecording(file);
    viewer.pause();
    viewer.waitFor("its name", () -> viewer.text("status-message").endsWith("paused"));
    Label message = viewer.node("status-message", Label.class);
    viewer.waitFor("room", () -> message.getWidth() >= message.prefWidth(-1) - 0.5);
  }

  private boolean isWithinWindow(String id) {
    Node node = viewer.node(id, Node.class);
    return viewer.onFx(
        () -> {
          Bounds place = node.localToScene(node.getLayoutBounds());
          return place.getMinX() >= -1 && place.getMaxX() <= viewer.stage.getScene().getWidth() + 1;
        });
  }

  private static SplitPane splitPaneOf(Node node) {
    Node above = node.getParent();
    while (!(above instanceof SplitPane)) {
      above = above.getParent();
    }
    return (SplitPane) above;
  }

  @Test
  void plotsMoveToASeparateWindowAndBack() {
    viewer = ViewerHarness.withBlob();
    run("plots-apart");
    viewer.waitFor("plots elsewhere", () -> viewer.isThere("plots") && !isInWindow("plots"));
    Node plots = viewer.node("plots", Node.class);
    assertTrue(viewer.onFx(() -> plots.getScene().getWindow().isShowing()));
    viewer.run(() -> plots.getScene().getWindow().hide());
    viewer.waitFor("plots below the events", () -> isInWindow("plots"));
  }

  @Test
  void commandPaletteOpensInTheWindowOfThePlots() {
    viewer = ViewerHarness.withBlob();
    run("plots-apart");
    viewer.waitFor("plots elsewhere", () -> viewer.isThere("plots") && !isInWindow("plots"));
    Window own = viewer.onFx(() -> viewer.node("plots", Node.class).getScene().getWindow());
    viewer.run(own::requestFocus);
    viewer.waitFor("its focus", own::isFocused);
    viewer.press(KeyCode.CONTROL, KeyCode.K);
    viewer.waitFor("the palette", () -> viewer.isThere("palette-search"));
    Popup palette =
        (Popup) viewer.onFx(() -> viewer.node("palette-search", Node.class).getScene().getWindow());
    assertEquals(own, palette.getOwnerWindow());
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("it is closed", () -> !viewer.isThere("palette-search"));
    viewer.press(KeyCode.CONTROL, KeyCode.G);
    viewer.waitFor("plots below the events", () -> isInWindow("plots"));
  }

  @Test
  void commandPaletteBelongsToTheWindowAlsoWhileATooltipIsShown() {
    viewer = ViewerHarness.withBlob();
    Tooltip tooltip = viewer.onFx(() -> new Tooltip("help"));
    viewer.run(() -> tooltip.show(viewer.stage, 10, 10));
    viewer.press(KeyCode.CONTROL, KeyCode.K);
    viewer.waitFor("the palette", () -> viewer.isThere("palette-search"));
    Popup palette =
        (Popup) viewer.onFx(() -> viewer.node("palette-search", Node.class).getScene().getWindow());
    viewer.run(tooltip::hide);
    assertEquals(viewer.stage, palette.getOwnerWindow());
    assertTrue(viewer.onFx(palette::isShowing), "it stays without the tooltip");
  }

  @Test
  void captionDoesNotCoverTheFlyAndButtonNamesAreNotTruncated() {
    viewer = new ViewerHarness();
    run("open-scene");
    viewer.waitUntilOpen("Fly scene");
    viewer.waitFor(
        "wings are found",
        () ->
            viewer.window.context().playback().speedProperty().get()
                == FlyStartFeature.SLOW_MOTION);
    for (double[] size : new double[][] {{700, 500}, {1024, 700}, {1280, 820}}) {
      viewer.run(
          () -> {
            viewer.stage.setWidth(size[0]);
            viewer.stage.setHeight(size[1]);
          });
      viewer.waitFor(
          "the picture below bar and caption at " + size[0],
          () ->
              !viewer.stage.getScene().getRoot().isNeedsLayout()
                  && top("event-view") >= bottom("fly-caption") - 0.5
                  && top("fly-caption") >= bottom("show-as") - 0.5
                  && top("show-as") >= bottom("menu") - 0.5);
      ToggleButton objects = viewer.node("usual-objects", ToggleButton.class);
      viewer.waitFor(
          "both words, or the icon alone, at " + size[0],
          () ->
              objects.getContentDisplay() == ContentDisplay.GRAPHIC_ONLY
                  || objects.getHeight() >= objects.prefHeight(-1) - 0.5);
    }
  }

  private double top(String id) {
    return viewer.onFx(() -> onScreen(viewer.node(id, Node.class)).getMinY());
  }

  private double bottom(String id) {
    return viewer.onFx(() -> onScreen(viewer.node(id, Node.class)).getMaxY());
  }

  private static Bounds onScreen(Node node) {
    return node.localToScene(node.getLayoutBounds());
  }
}
