package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.ReadOptions;
import haltere.testing.Recorded;
import haltere.ui.plot.InertialFeed;
import haltere.ui.plot.Lane;
import java.nio.file.Path;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Frames, inertial samples and triggers of a real recording of a DAVIS346. */
class SamplesTest {
  private ViewerHarness viewer;

  @BeforeEach
  void open() {
    Path file = Recorded.file("davis346-events-frames-imu.aedat4");
    viewer = new ViewerHarness();
    viewer.openRecording(file);
  }

  @AfterEach
  void close() {
    if (viewer != null) {
      viewer.close();
    }
  }

  @Test
  void theOnlyFrameOfARecordingWithoutEventsIsDrawn() {
    Path file = Recorded.file("gray16-frame.aedat4");
    viewer.run(() -> viewer.window.context().sessions().open(file, ReadOptions.DEFAULT));
    // of 2 by 2 pixels with 10 bits, in 16, the right lower one alone is bright
    viewer.waitFor("the frame", () -> colour(0.6, 0.75).getBrightness() > 0.4);
    assertTrue(colour(0.4, 0.25).getBrightness() < 0.1);
  }

  private Color colour(double across, double down) {
    return viewer.onFx(
        () -> {
          WritableImage picture = viewer.picture("event-view");
          int x = (int) (across * picture.getWidth());
          return picture.getPixelReader().getColor(x, (int) (down * picture.getHeight()));
        });
  }

  /** Mean of red, green and blue in the middle of the picture, 0 to 1. */
  private double brightness() {
    return brightness("event-view");
  }

  private double brightness(String view) {
    return viewer.onFx(
        () -> {
          WritableImage picture = viewer.picture(view);
          PixelReader pixels = picture.getPixelReader();
          double sum = 0;
          int count = 0;
          for (int y = (int) picture.getHeight() / 4; y < picture.getHeight() * 3 / 4; y += 3) {
            for (int x = (int) picture.getWidth() / 3; x < picture.getWidth() * 2 / 3; x += 3) {
              sum += pixels.getColor(x, y).getBrightness();
              count++;
            }
          }
          return sum / count;
        });
  }

  @Test
  void framesLieBelowTheEventsAlsoAfterAJumpAndCanBeSwitchedOff() {
    viewer.waitFor(
        "the switch of frames", () -> viewer.onFx(viewer.node("frames", Node.class)::isVisible));
    viewer.waitFor("a frame", () -> brightness() > 0.15);
    viewer.pause();
    viewer.run(() -> viewer.window.context().playback().seek(1_000_000));
    viewer.waitFor("the jump", () -> Math.abs(viewer.status().elapsedUs() - 1_000_000) < 20_000);
    viewer.waitFor("the frame of that moment", () -> brightness() > 0.15);
    viewer.click("frames");
    viewer.waitFor("no frame", () -> brightness() < 0.12);
  }

  @Test
  void bothPicturesOfAComparisonHaveTheFrames() {
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("a second picture", () -> viewer.isThere("second-event-view"));
    viewer.waitFor("its frame", () -> brightness("second-event-view") > 0.15);
    viewer.pause();
    viewer.run(() -> viewer.window.context().playback().seek(1_000_000));
    viewer.waitFor("the jump", () -> Math.abs(viewer.status().elapsedUs() - 1_000_000) < 20_000);
    viewer.waitFor("the frame of that moment", () -> brightness("second-event-view") > 0.15);
    viewer.click("frames");
    viewer.waitFor("no frame", () -> brightness("second-event-view") < 0.12);
  }

  @Test
  void inertialSamplesAreCurvesOfThreeAxes() {
    viewer.run(() -> viewer.window.context().actions().run("show-plots"));
    viewer.run(() -> viewer.window.context().panels().plots().addLane(InertialFeed.ACCELERATION));
    viewer.waitFor(
        "three axes",
        () -> {
          List<Lane> lanes = viewer.window.context().panels().plots().lanes();
          return !lanes.isEmpty() && viewer.onFx(() -> lanes.get(0).curves().size()) == 3;
        });
    assertEquals("g", InertialFeed.ACCELERATION.unit());
    assertEquals("\u00b0/s", InertialFeed.ROTATION.unit());
  }

  @Test
  void triggersAreNamedOverThePictureAndListed() {
    viewer.waitFor(
        "the facts",
        () ->
            viewer.onFx(
                () -> viewer.window.context().sessions().factsProperty().get().isPresent()));
    assertEquals(
        236,
        viewer.onFx(
            () ->
                viewer
                    .window
                    .context()
                    .sessions()
                    .factsProperty()
                    .get()
                    .orElseThrow()
                    .triggers()
                    .size()));
    viewer.waitFor("a name", () -> viewer.onFx(viewer.node("trigger-mark", Node.class)::isVisible));
    assertTrue(viewer.text("trigger-mark").matches("(Exposure|Readout).*"));
  }
}
