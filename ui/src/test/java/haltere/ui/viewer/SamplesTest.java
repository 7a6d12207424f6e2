package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SampleKind;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.playback.Mark;
import haltere.testing.Recorded;
import haltere.ui.plot.InertialFeed;
import haltere.ui.plot.Lane;
import haltere.ui.viewer.playback.SeekBar;
import haltere.ui.viewer.session.RecordingFacts;
import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.LongStream;
import javafx.scene.control.Label;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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
    viewer.waitFor("the switch of frames", () -> viewer.isThere("frames"));
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

  private RecordingFacts facts() {
    viewer.waitFor(
        "the facts",
        () ->
            viewer.onFx(
                () -> viewer.window.context().sessions().factsProperty().get().isPresent()));
    return viewer
        .onFx(() -> viewer.window.context().sessions().factsProperty().get())
        .orElseThrow();
  }

  @Test
  void frameTimingIsNamedByTheMouseAtItsTicksAndNotOverThePicture() {
    assertEquals(236, facts().triggers().size());
    assertEquals(List.of(), facts().signals());
    viewer.pause();
    SeekBar bar = viewer.node("seek-bar", SeekBar.class);
    double share = facts().triggers().get(100).elapsedUs() / (double) viewer.status().durationUs();
    viewer.moveOver("seek-bar", share);
    viewer.waitFor(
        "the name of the tick",
        () ->
            bar.getChildrenUnmodifiable().stream()
                .anyMatch(
                    each ->
                        each instanceof Label text
                            && text.getText().matches(".*(Exposure|Readout).*")));
    assertFalse(viewer.isThere("trigger-mark"));
  }

  @Test
  void signalsAreNamedOverThePicture(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("signal.aedat4");
    writeWithTriggerAt(1_000_000, file);
    viewer.openRecording(file);
    Mark signal = facts().signals().get(0);
    viewer.pause();
    viewer.run(() -> viewer.window.context().playback().seek(signal.elapsedUs()));
    viewer.waitFor("its name", () -> viewer.isThere("trigger-mark"));
    assertEquals("Trigger 0 falling, Trigger 0 rising", viewer.text("trigger-mark"));
  }

  private static void writeWithTriggerAt(long timeUs, Path file) throws IOException {
    WriteOptions options =
        WriteOptions.of(BlobSource.GEOMETRY).withSamples(EnumSet.of(SampleKind.TRIGGER));
    try (RecordingWriter writer = Recordings.forWriting(file).create(file, options).orElseThrow()) {
      writer.write(events(0, timeUs));
      for (Trigger.Edge edge : List.of(Trigger.Edge.RISING, Trigger.Edge.FALLING)) {
        writer.write(new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge, 0));
      }
      writer.write(events(timeUs, 2 * timeUs));
      writer.finish();
    }
  }

  private static EventPacket events(long fromUs, long toUs) {
    long stepUs = (toUs - fromUs) / 100;
    long[] timesUs = LongStream.range(0, 100).map(i -> fromUs + i * stepUs).toArray();
    return EventPacket.of(timesUs, new int[timesUs.length]);
  }
}
