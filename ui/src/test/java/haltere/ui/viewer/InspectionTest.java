package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.playback.Slicing;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.picture.MeasuredLine;
import haltere.ui.viewer.picture.RegionTool;
import haltere.ui.viewer.picture.ScaleLegend;
import haltere.ui.viewer.playback.PlaybackController;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Looking closely, in the real window. */
class InspectionTest {
  private ViewerHarness viewer;

  @BeforeEach
  void open() {
    viewer = ViewerHarness.withBlob();
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private String regionWords() {
    return seeing().region().orElseThrow().label();
  }

  private InspectionFeature seeing() {
    return viewer.window.feature(InspectionFeature.class);
  }

  @Test
  void allDisplayModesDiffer() {
    viewer.waitFor("some events", () -> viewer.status().elapsedUs() > 200_000);
    viewer.pause();
    Set<Integer> pictures = new HashSet<>();
    for (DisplayMode mode : DisplayMode.values()) {
      viewer.run(() -> viewer.window.context().display().modeProperty().set(mode));
      viewer.run(() -> viewer.window.context().playback().step(1));
      viewer.waitFor("the picture", () -> !viewer.session().display().renderer().isStale());
      long frames = viewer.onFx(viewer.window.context().panels()::framesShown);
      viewer.run(() -> viewer.window.context().playback().step(1));
      viewer.waitFor("its frame", () -> viewer.window.context().panels().framesShown() > frames);
      pictures.add(viewer.onFx(() -> hash(viewer.picture())));
    }
    assertEquals(DisplayMode.values().length, pictures.size());
    ChoiceBox<?> choice = viewer.node("show-as", ChoiceBox.class);
    assertEquals(DisplayMode.FREQUENCY, viewer.onFx(choice::getValue));
  }

  private static int hash(WritableImage image) {
    int hash = 1;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        hash = 31 * hash + image.getPixelReader().getArgb(x, y);
      }
    }
    return hash;
  }

  @Test
  void readOutShowsLastEventAndRateAtTheMouse() {
    EventView view = viewer.window.context().panels().view();
    double shareX = viewer.onFx(() -> view.viewpoint().viewX(64) / view.getWidth());
    double shareY = viewer.onFx(() -> view.viewpoint().viewY(BlobSource.Y) / view.getHeight());
    viewer.click("event-view", shareX, shareY);
    viewer.waitFor(
        "polarity, age and rate",
        () -> viewer.text("cursor-readout").matches("x 6\\d   y .* (ON|OFF) .* ago .*ev/s near"));
  }

  @Test
  void readOutStandsAboveTheLegendInANarrowPicture() {
    viewer.run(() -> viewer.window.context().actions().run("show-as-frequency"));
    viewer.run(() -> viewer.stage.setWidth(ViewerWindow.MIN_WIDTH));
    EventView view = viewer.window.context().panels().view();
    double shareX = viewer.onFx(() -> view.viewpoint().viewX(64) / view.getWidth());
    double shareY = viewer.onFx(() -> view.viewpoint().viewY(BlobSource.Y) / view.getHeight());
    viewer.click("event-view", shareX, shareY);
    Label readout = viewer.node("cursor-readout", Label.class);
    viewer.waitFor("a long read-out", () -> readout.getText().contains("ev/s near"));
    viewer.waitFor(
        "no overlap",
        () -> !readout.getBoundsInParent().intersects(view.legend().getBoundsInParent()));
    assertTrue(viewer.onFx(() -> view.legend().isVisible()));
  }

  @Test
  void readOutIsWholeInThePicturesOfAComparison() {
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.run(() -> viewer.stage.setWidth(ViewerWindow.MIN_WIDTH));
    EventView view = viewer.window.context().panels().view();
    viewer.waitFor("a narrow picture", () -> view.getWidth() < ViewerWindow.MIN_WIDTH / 2);
    viewer.click("event-view", 0.5, 0.5);
    Label readout = viewer.node("cursor-readout", Label.class);
    viewer.waitFor("a long read-out", () -> readout.getText().contains("ev/s near"));
    viewer.waitFor("all of it", () -> readout.getBoundsInParent().getMaxX() <= view.getWidth());
    assertTrue(viewer.onFx(() -> readout.getHeight() > 2 * readout.getFont().getSize()));
  }

  @Test
  void legendInTheNarrowestPictureIsShorterAndWhole() {
    viewer.run(() -> viewer.window.context().actions().run("show-as-time-surface"));
    EventView view = viewer.window.context().panels().view();
    ScaleLegend legend = view.legend();
    viewer.waitFor("a legend", legend::isVisible);
    viewer.run(
        () -> {
          view.resize(view.getMinWidth(), view.getMinHeight());
          view.layout();
          legend.layout();
          assertEquals(1, legend.getOpacity());
          assertTrue(legend.getLayoutX() >= 0, "the left end at " + legend.getLayoutX());
          for (Node part : legend.getChildren()) {
            double right = part.getLayoutX() + part.getLayoutBounds().getWidth();
            assertTrue(right <= legend.getWidth(), part + " ends at " + right);
            assertTrue(
                !(part instanceof Label)
                    || part.getLayoutBounds().getWidth() >= part.prefWidth(-1));
          }
        });
  }

  @Test
  void pauseShowsTheRateAtTheMouse() {
    viewer.waitFor("some events", () -> viewer.status().elapsedUs() > 300_000);
    viewer.pause();
    for (double share : new double[] {0.4, 0.5, 0.6}) {
      // the pause itself may still be about to measure the first one
      String before = viewer.text("cursor-readout");
      viewer.moveOver("event-view", share);
      viewer.waitFor(
          "a rate at " + share,
          () -> {
            String text = viewer.text("cursor-readout");
            return text.endsWith("ev/s near") && !text.equals(before);
          });
    }
  }

  @Test
  void regionShowsItsRateAndFrequency() {
    viewer.run(() -> seeing().setRegion(Optional.of(PixelRegion.between(0, 0, 127, 127))));
    viewer.waitFor(
        "a rate in words", () -> regionWords().contains("ev/s") && !regionWords().equals("0 ev/s"));
    viewer.press(KeyCode.G);
    viewer.click("event-view", 0.5, 0.5);
    viewer.waitFor("a click takes it away", () -> seeing().region().isEmpty());
  }

  private String tapeWords() {
    var tape = viewer.window.context().display().tapeProperty();
    return viewer.onFx(() -> tape.get().map(MeasuredLine::label).orElse(""));
  }

  @Test
  void tapeMeasuresAndToolsReplaceEachOther() {
    viewer.press(KeyCode.T);
    EventView view = viewer.window.context().panels().view();
    viewer.waitFor("the tape is in the hand", () -> view.tool().isPresent());
    assertTrue(viewer.text("status-message").contains("measure"));
    viewer.run(
        () -> {
          view.tool().orElseThrow().pressed(10, 10);
          view.tool().orElseThrow().dragged(40, 50);
        });
    assertEquals("50.0 px   53.1\u00b0   x 30.0   y 40.0", tapeWords());
    viewer.press(KeyCode.G);
    viewer.waitFor("the other tool", () -> view.tool().orElseThrow() instanceof RegionTool);
    assertEquals("", tapeWords());
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("none", () -> view.tool().isEmpty());
    assertFalse(viewer.text("status-message").contains("Esc"), "and no hint");
  }

  @Test
  void keysZoomAndPan() {
    EventView view = viewer.window.context().panels().view();
    double before = viewer.onFx(view.viewpoint()::scale);
    viewer.run(() -> viewer.window.context().actions().run("zoom-in"));
    viewer.waitFor("closer", () -> view.viewpoint().scale() > before * 1.3);
    double place = viewer.onFx(() -> view.viewpoint().viewX(64));
    viewer.run(() -> viewer.window.context().actions().run("pan-right"));
    viewer.waitFor("it moved", () -> view.viewpoint().viewX(64) < place - 10);
    viewer.press(KeyCode.P);
    viewer.waitFor("single pixels", () -> view.viewpoint().scale() > 30);
  }

  @Test
  void slidersRotateTheSpaceTimeView() {
    viewer.run(() -> viewer.window.context().actions().run("show-space-time"));
    viewer.waitFor("the panel", () -> viewer.isThere("space-time"));
    Node panel = viewer.node("space-time", Node.class);
    viewer.waitFor("events in it", () -> colours(panel.snapshot(null, null)) > 20);
    Slider turn = viewer.node("space-time-turn", Slider.class);
    viewer.pause();
    int before = viewer.onFx(() -> hash(panel.snapshot(null, null)));
    viewer.run(() -> turn.setValue(-120));
    viewer.waitFor("another view", () -> hash(panel.snapshot(null, null)) != before);
    viewer.waitFor("its value", () -> viewer.text("space-time-turn-value").equals("-120°"));
    assertEquals("100 ms", viewer.text("space-time-span-value"));
    assertEquals("now", viewer.text("space-time-slice-value"));
    viewer.run(() -> viewer.node("space-time-slice", Slider.class).setValue(0.2));
    viewer.waitFor("its value", () -> viewer.text("space-time-slice-value").equals("-20.0 ms"));
    viewer.run(() -> viewer.window.context().actions().run("show-space-time"));
    viewer.waitFor("it is gone", () -> !viewer.isThere("space-time"));
  }

  private static int colours(WritableImage image) {
    Set<Integer> found = new HashSet<>();
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        found.add(image.getPixelReader().getArgb(x, y));
      }
    }
    return found.size();
  }

  @Test
  void beatSlicesFollowTheWingTracker() {
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    viewer.run(() -> viewer.window.context().actions().run("slices-beat"));
    viewer.waitFor(
        "the length of a beat",
        () ->
            viewer.window.context().playback().slicingProperty().get()
                    instanceof Slicing.ByTime slice
                && slice.sliceUs() != 5_000
                && Math.abs(slice.sliceUs() - 5_000) < 700);
    viewer.run(() -> viewer.window.context().actions().run("slices-beat"));
    assertEquals(
        PlaybackController.SMOOTH,
        viewer.onFx(() -> viewer.window.context().playback().slicingProperty().get()));
  }
}
