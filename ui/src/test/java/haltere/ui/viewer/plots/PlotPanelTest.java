package haltere.ui.viewer.plots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.ReadOptions;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.plot.Curve;
import haltere.ui.plot.InertialFeed;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.session.SessionRequest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Plots of what filters publish, in the real window. */
class PlotPanelTest {
  private static final PlotField X = new PlotField("object-tracker", "objects", "x_px");

  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private PlotPanel plots() {
    return viewer.window.context().panels().plots();
  }

  private long lastUs() {
    return lastUs(0);
  }

  private long lastUs(int number) {
    return viewer.onFx(
        () -> {
          Lane lane = plots().lanes().get(number);
          return lane.lastUs(lane.fields().get(0));
        });
  }

  private void plot(PlotField field) {
    viewer.run(
        () -> {
          viewer.window.context().actions().run("show-plots");
          plots().addLane(field);
        });
  }

  @Test
  void publishedResultsArePlottedDuringPlayback() {
    viewer = ViewerHarness.withBlob();
    plot(X);
    viewer.waitFor("samples", () -> lastUs() > 100_000);
    viewer.waitFor("a curve on the screen", () -> hasCurve(PlotColours.DARK));
    viewer.run(() -> viewer.window.context().display().themeProperty().set(Theme.LIGHT));
    viewer.waitFor(
        "the curve in the colours of the light theme", () -> hasCurve(PlotColours.LIGHT));
  }

  @Test
  void plotSetReplacesOtherPlots() {
    viewer = ViewerHarness.withBlob();
    plot(PlotField.EVENT_RATE);
    PlotField other = new PlotField(X.stage(), X.outlet(), "y_px");
    viewer.run(() -> plots().fieldsProperty().set(List.of(List.of(X, other), List.of(X))));
    assertEquals(
        List.of(List.of(X, other), List.of(X)),
        viewer.onFx(() -> plots().lanes().stream().map(Lane::fields).toList()));
    viewer.waitFor("samples", () -> lastUs() > 0);
  }

  @Test
  void initialPlotsOfASceneAreRemovedWithItUnlessOthersWereAdded() throws IOException {
    viewer = new ViewerHarness();
    Path recording = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(recording, 200_000);
    viewer.run(() -> viewer.window.context().sessions().open(SessionRequest.scene()));
    viewer.waitFor("its plots", () -> plots().lanes().size() == 2);
    viewer.run(() -> viewer.window.context().sessions().open(recording, ReadOptions.DEFAULT));
    viewer.waitUntilOpen("blob.aedat");
    viewer.waitFor("no plots", () -> plots().lanes().isEmpty());
    viewer.waitFor("no panel", () -> !viewer.isThere("plots"));
    viewer.run(() -> viewer.window.context().sessions().open(SessionRequest.scene()));
    viewer.waitFor("its plots again", () -> plots().lanes().size() == 2);
    viewer.run(() -> plots().addLane(X));
    viewer.run(() -> viewer.window.context().sessions().open(recording, ReadOptions.DEFAULT));
    viewer.waitUntilOpen("blob.aedat");
    assertEquals(3, viewer.onFx(() -> plots().lanes().size()));
  }

  @Test
  void excessLanesScrollAndDoNotOverlap() {
    viewer = ViewerHarness.withBlob();
    plot(PlotField.EVENT_RATE);
    for (int i = 0; i < 12; i++) {
      viewer.run(() -> plots().addLane(X));
    }
    Node head = viewer.node("add-plot", Node.class);
    viewer.waitFor(
        "the first lane below the head",
        () -> {
          Node lane = plots().lookup(".plot-lane");
          if (lane == null) {
            return false; // it is not laid out yet
          }
          double top = lane.localToScene(lane.getLayoutBounds()).getMinY();
          return lane.getLayoutBounds().getHeight() > 0
              && top >= head.localToScene(head.getLayoutBounds()).getMaxY();
        });
    viewer.waitFor("a scroll bar", () -> !plots().lookupAll(".scroll-bar:vertical").isEmpty());
  }

  @Test
  void plotWithoutAPublisherStatesIt() {
    viewer = ViewerHarness.withBlob();
    plot(new PlotField("wing-tracker", "wings", "angle_rad"));
    viewer.waitFor("a note", () -> viewer.isThere("plot-note"));
    Label note = viewer.node("plot-note", Label.class);
    viewer.waitFor("the note", note::isVisible);
    assertTrue(viewer.onFx(note::getText).contains("wing-tracker / wings / angle_rad"));
    plot(X);
    viewer.waitFor("samples", () -> lastUs(1) > 0);
    List<Boolean> notes =
        viewer.onFx(
            () -> plots().lookupAll(".plot-note").stream().map(Node::isVisible).sorted().toList());
    assertEquals(List.of(false, true), notes);
  }

  private static PlayerStatus paused(long timeUs, double rateEps) {
    return status(timeUs, rateEps, 0);
  }

  private static PlayerStatus status(long timeUs, double rateEps, long runUpUs) {
    return new PlayerStatus(
        State.PAUSED, timeUs, timeUs, 1, 1, 1, 0, "", 0, 0, 0, rateEps, 0, 1, runUpUs, "", 0);
  }

  private List<String> labels() {
    return plots().lookupAll(".label").stream().map(label -> ((Label) label).getText()).toList();
  }

  private void plotEventRate() {
    viewer = ViewerHarness.withBlob();
    plot(PlotField.EVENT_RATE);
    viewer.waitFor("the lane", () -> plots().lookup(".plot-lane") != null);
  }

  @Test
  void valuesOfARunUpAreNotDrawnBeforeItsEnd() {
    plotEventRate();
    viewer.run(
        () -> {
          long nanos = System.nanoTime() + 1_000_000_000;
          plots().reset(new InertialFeed());
          plots().update(paused(1_000_000, 111), nanos);
          plots().update(status(900_000, 222, 50_000), nanos + 200_000_000);
          assertTrue(labels().stream().anyMatch(text -> text.contains("111")), labels()::toString);
          plots().update(status(950_000, 333, 0), nanos + 400_000_000);
          assertTrue(labels().stream().anyMatch(text -> text.contains("333")), labels()::toString);
        });
  }

  @Test
  void lastSamplesBeforeAPauseAreDrawn() {
    plotEventRate();
    viewer.run(
        () -> {
          // within one pulse, so that the window's own updates do not count
          long nanos = System.nanoTime() + 1_000_000_000;
          plots().reset(new InertialFeed());
          plots().update(paused(1_000_000, 111), nanos);
          plots().update(paused(1_000_100, 222), nanos + 1_000_000);
          plots().update(paused(1_000_100, 222), nanos + 40_000_000);
          plots().update(paused(1_000_100, 222), nanos + 200_000_000);
          assertTrue(labels().stream().anyMatch(text -> text.contains("222")), labels()::toString);
        });
  }

  private boolean hasCurve(PlotColours colours) {
    WritableImage image = plots().snapshot(null, null);
    PixelReader pixels = image.getPixelReader();
    Color colour = colours.curve(plots().lanes().get(0).curves().get(0));
    int like = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 70; x < image.getWidth(); x++) {
        if (pixels.getColor(x, y).equals(colour)) {
          like++;
        }
      }
    }
    return like > 20;
  }

  @Test
  void eventRateIsPlottedWithoutFilters() {
    viewer = ViewerHarness.withBlob();
    plot(PlotField.EVENT_RATE);
    viewer.waitFor(
        "a rate above zero",
        () ->
            viewer.onFx(
                () -> {
                  List<Curve> curves = plots().lanes().get(0).curves();
                  return !curves.isEmpty() && curves.get(0).last() > 0;
                }));
  }

  @Test
  void plotContinuesInTheNextRecording() throws IOException {
    viewer = ViewerHarness.withBlob();
    plot(X);
    viewer.waitFor("samples", () -> lastUs() > 0);
    Path file = folder.resolve("next.aedat");
    ViewerHarness.writeRecording(file, 3_000_000);
    viewer.run(() -> viewer.window.dropped(List.of(file.toFile())));
    viewer.waitUntilOpen("next.aedat");
    viewer.run(() -> viewer.window.context().actions().run("usual-objects"));
    viewer.waitFor("samples of the recording", () -> lastUs() > 0 && lastUs() < 3_000_000);
  }

  @Test
  void scrollingBackStopsFollowingAndTheTableHasTheVisiblePart() throws IOException {
    viewer = ViewerHarness.withBlob();
    plot(X);
    viewer.waitFor("half a second", () -> lastUs() > 500_000);
    viewer.run(() -> plots().window().scroll(-100_000));
    long endUs = viewer.onFx(() -> plots().window().toUs());
    long beforeUs = lastUs();
    viewer.waitFor("more samples", () -> lastUs() > beforeUs + 200_000);
    assertEquals(endUs, viewer.onFx(() -> plots().window().toUs()));
    assertFalse(viewer.onFx(() -> plots().window().isFollowing()));
    List<String> rows = viewer.onFx(() -> plots().table()).lines().toList();
    assertTrue(rows.size() > 10, rows.size() + " rows");
    long lastRowUs = Long.parseLong(rows.get(rows.size() - 1).split(",")[0]);
    assertTrue(lastRowUs <= endUs);
  }

  @Test
  void hiddenPlotsUseNoSpace() {
    viewer = ViewerHarness.withBlob();
    plot(X);
    viewer.run(() -> viewer.window.context().actions().run("show-plots"));
    assertTrue(viewer.onFx(() -> plots().getScene() == null));
  }
}
