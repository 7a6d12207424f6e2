package haltere.ui.viewer.wings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.AtomicFile;
import haltere.core.playback.ScenePlayable;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingFilterEdit.Table;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingFilterState.Source;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.picture.ViewTool;
import haltere.ui.viewer.session.InitialView;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.wing.WingLogFormat;
import haltere.ui.wing.WingLogFormat.Layout;
import haltere.ui.wing.WingLogFormat.Rows;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The wing tracker's filters, tool and log, in the real window. */
class WingsFeatureTest {
  @TempDir Path folder;
  private ViewerHarness viewer;
  private WingsFeature wings;

  @BeforeEach
  void openTheFly() {
    viewer = new ViewerHarness();
    wings = viewer.window.feature(WingsFeature.class);
    FlySceneSettings steady =
        FlySceneSettings.defaults()
            .with("disturbances.manoeuvres.everyS=0", "fly.wing.visibleShare=0.1");
    viewer.run(
        () -> {
          viewer
              .window
              .context()
              .sessions()
              .open(
                  new SessionRequest(
                      () -> new ScenePlayable(() -> new FlyScene(steady), "fly"),
                      Optional.empty(),
                      haltere.core.format.ReadOptions.DEFAULT,
                      "fly",
                      InitialView.FLY));
          viewer.window.context().actions().run("show-wings");
        });
    viewer.waitFor("a filter of the left wing", () -> filter().isPresent());
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private Optional<WingFilterState> filter() {
    return wings.seen().stream()
        .flatMap(view -> view.filters().stream())
        .filter(state -> state.part() == WingPart.LEFT)
        .findFirst();
  }

  private FlyGeometry geometry() {
    return wings.seen().orElseThrow().geometry().orElseThrow();
  }

  private void enter(String id, String text) {
    viewer.waitFor("#" + id, () -> viewer.isThere(id));
    TextField entry = viewer.node(id, TextField.class);
    viewer.run(
        () -> {
          entry.requestFocus();
          entry.setText(text);
          entry.fireEvent(new javafx.event.ActionEvent());
        });
  }

  @Test
  void panelHasTheCommandsOfTheMenuOnlyWithATracker() {
    assertEquals("Exchange head and tail", viewer.text("wings-panel-flip"));
    viewer.run(
        () -> viewer.session().chain().stages().forEach(viewer.window.context().editor()::remove));
    viewer.waitFor("no commands", () -> !viewer.isThere("wings-panel-flip"));
    assertFalse(viewer.isThere("wings-restart"));
  }

  @Test
  void filterValuesAreShownAndEditedDuringPlayback() {
    enter("process-noise-3-0", "77");
    viewer.waitFor(
        "Q of the frequency", () -> filter().get().value(Table.PROCESS_NOISE, 3, 0) == 77);
    enter("measurement-noise-0-0", "0.0123");
    viewer.waitFor(
        "R", () -> filter().get().r() == 0.0123 && filter().get().rSource() == Source.MANUAL);
    viewer.pause();
    enter("state-1-0", "0.5");
    viewer.waitFor("x", () -> filter().get().value(Table.STATE, 1, 0) == 0.5);
    enter("covariance-0-0", "0.25");
    viewer.waitFor("P", () -> filter().get().value(Table.COVARIANCE, 0, 0) == 0.25);
    viewer.run(
        () -> viewer.node("covariance-column", ChoiceBox.class).getSelectionModel().select(1));
    assertFalse(viewer.isThere("covariance-0-0"), "the column of the state that was chosen before");
    enter("covariance-0-1", "9");
    viewer.waitFor(
        "what no covariance can be is refused in a line",
        () -> viewer.text("status-message").contains("more than the variances"));
    viewer.run(() -> wings.restart(WingPart.LEFT));
    viewer.waitFor(
        "R is learnt again",
        () ->
            filter().get().rSource() == Source.ESTIMATOR
                && filter().get().value(Table.PROCESS_NOISE, 3, 0) != 77);
  }

  @Test
  void adaptiveNoiseIsFixedAndReleasedByClicks() {
    String id = "source-process-noise-3";
    viewer.waitFor(
        "the frequency's noise is the estimator's",
        () -> viewer.isThere(id) && viewer.node(id, Hyperlink.class).getText().equals("adaptive"));
    Hyperlink source = viewer.node(id, Hyperlink.class);
    viewer.run(source::fire);
    viewer.waitFor("manual", () -> source.getText().equals("manual"));
    assertEquals(Source.MANUAL, viewer.onFx(() -> filter().get().source(Table.PROCESS_NOISE, 3)));
    viewer.run(source::fire);
    viewer.waitFor("adaptive again", () -> source.getText().equals("adaptive"));
    Hyperlink settings = viewer.node("source-process-noise-4", Hyperlink.class);
    assertFalse(viewer.onFx(settings::isVisible), "that of the width follows from the settings");
    enter("process-noise-4-0", "0.002");
    viewer.waitFor("its own", () -> settings.isVisible() && settings.getText().equals("manual"));
    viewer.run(settings::fire);
    viewer.waitFor("as before", () -> !settings.isVisible());
    for (int i = 0; i < viewer.onFx(() -> filter().get().names().size()); i++) {
      int row = i;
      assertTrue(viewer.onFx(() -> filter().get().value(Table.PROCESS_NOISE, row, 0)) > 0);
    }
  }

  @Test
  void trackerStateAndSearchStepsAreShown() {
    viewer.waitFor(
        "the steps", () -> viewer.text("wings-search").startsWith("Tracks both wings.\n1. Two"));
    String text = viewer.text("wings-search");
    assertTrue(text.contains("\n2. Beat ") && text.contains("body axis 9"), text);
  }

  @Test
  void originalPresetIsAppliedAndUndoneByClicks() {
    WingTrackerSettings before = viewer.onFx(() -> wings.seen().get().settings());
    viewer.run(() -> viewer.node("expand-wing-tracker", Button.class).fire());
    viewer.run(() -> viewer.node("preset-original-wing-tracker", Button.class).fire());
    viewer.waitFor(
        "a filter for each edge",
        () -> wings.seen().get().settings().equals(WingTrackerSettings.original()));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("as it was", () -> wings.seen().get().settings().equals(before));
  }

  @Test
  void editedEntryIsNotOverwritten() {
    TextField entry = viewer.node("state-2-0", TextField.class);
    viewer.run(
        () -> {
          entry.requestFocus();
          entry.setText("1.2");
        });
    long before = viewer.onFx(() -> filter().get().events());
    viewer.waitFor("newer numbers", () -> filter().get().events() > before + 500);
    assertEquals("1.2", viewer.onFx(entry::getText));
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("the number in force", () -> !entry.getText().equals("1.2"));
  }

  @Test
  void disabledEdgesUpdateTheSettingsOfTheChain() {
    CheckBox box = viewer.node("wings-edge-right-leading", CheckBox.class);
    viewer.run(() -> box.fire());
    viewer.waitFor("the setting", () -> !wings.seen().get().settings().output().rightLeading());
    viewer.run(() -> viewer.window.context().actions().run("wings-flip"));
    viewer.waitFor(
        "head and tail exchanged, and the edge still off",
        () ->
            wings.seen().get().settings().position().flipHeading()
                && !wings.seen().get().settings().output().rightLeading());
  }

  @Test
  void flyIsPlacedByTheMouse() {
    viewer.pause();
    viewer.run(() -> viewer.window.context().actions().run("wings-place"));
    // one that was under way when the fly stood still, and one after it
    lookAgain();
    lookAgain();
    FlyGeometry found = viewer.onFx(this::geometry);
    double away = 0.6 * found.sizePx();
    double turned = found.headingRad() + 0.2;
    drag(
        found.centreX() + away * Math.cos(found.headingRad()),
        found.centreY() + away * Math.sin(found.headingRad()),
        found.centreX() + away * Math.cos(turned),
        found.centreY() + away * Math.sin(turned));
    viewer.waitFor(
        "the heading as it was dragged",
        () -> Math.abs(Angles.wrapPi(geometry().headingRad() - turned)) < 0.01);
    double region = viewer.onFx(() -> wings.seen().orElseThrow().regionPx());
    drag(found.centreX() - region, found.centreY(), found.centreX() - region - 6, found.centreY());
    viewer.waitFor(
        "a larger region", () -> Math.abs(wings.seen().get().regionPx() - region - 6) < 0.1);
    double x = found.centreX() + 2;
    drag(x, found.centreY(), x, found.centreY());
    viewer.waitFor("the body where it was clicked", () -> Math.abs(geometry().centreX() - x) < 0.1);
  }

  private void lookAgain() {
    WingsView before = viewer.onFx(() -> wings.seen().orElseThrow());
    viewer.waitFor("another look", () -> wings.seen().orElseThrow() != before);
  }

  private void drag(double fromX, double fromY, double toX, double toY) {
    viewer.run(
        () -> {
          ViewTool tool = viewer.window.context().panels().view().tool().orElseThrow();
          tool.pressed(fromX, fromY);
          tool.dragged(toX, toY);
          tool.released(toX, toY);
        });
  }

  @Test
  void logOnAFullDiskEndsAndIsKept() throws IOException {
    Path file = folder.resolve("wings.txt");
    AtomicFile disk = AtomicFile.create(file, true);
    viewer.run(
        () ->
            wings.log(
                open ->
                    WingLogOutput.begin(
                        disk, new WingLogFormat(Rows.EVENT, Layout.TABLE), open.player())));
    viewer.waitFor("it logs", () -> viewer.text("status-message").startsWith("Logging"));
    // from here on nothing can be written
    disk.channel().close();
    viewer.waitFor(
        "it says why", () -> viewer.text("status-message").endsWith("logged before is kept"));
    assertFalse(
        viewer.onFx(
            () ->
                viewer
                    .window
                    .context()
                    .actions()
                    .find("wings-log")
                    .orElseThrow()
                    .on()
                    .orElseThrow()
                    .get()));
    assertFalse(viewer.text("status-message").contains("java."), viewer.text("status-message"));
    assertTrue(Files.readAllLines(file).get(0).startsWith("# haltere"));
  }

  @Test
  void logIsWrittenUntilStopped() throws IOException {
    Path file = folder.resolve("wings.txt");
    viewer.run(() -> viewer.window.context().playback().setSpeed(0.2));
    viewer.run(() -> wings.log(file));
    long from = viewer.status().elapsedUs();
    viewer.waitFor("a while", () -> viewer.status().elapsedUs() > from + 200_000);
    viewer.run(() -> viewer.window.context().actions().run("wings-log"));
    viewer.waitFor("the file", () -> Files.exists(file));
    List<String> lines = Files.readAllLines(file);
    assertTrue(lines.get(0).startsWith("# haltere") && lines.get(0).endsWith("wings of fly"));
    assertTrue(lines.stream().filter(line -> !line.startsWith("#")).count() > 100);
  }
}
