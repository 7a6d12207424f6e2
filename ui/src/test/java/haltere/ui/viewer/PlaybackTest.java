package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import atlantafx.base.theme.Styles;
import haltere.core.event.EventPacket;
import haltere.core.playback.Loop;
import haltere.core.playback.Mark;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.playback.ScenePlayable;
import haltere.core.playback.Slicing;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.playback.SeekBar;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Transport by buttons and keys, in the real window. */
class PlaybackTest {
  private static final long LENGTH_US = 4_000_000;

  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  @Test
  void spaceAndButtonTogglePlayback() {
    viewer = ViewerHarness.withBlob();
    viewer.waitFor("playing", () -> viewer.status().state() == State.PLAYING);
    viewer.press(KeyCode.SPACE);
    viewer.waitFor("paused by key", () -> viewer.status().state() == State.PAUSED);
    long elapsed = viewer.status().elapsedUs();
    viewer.click("play");
    viewer.waitFor(
        "playing by click",
        () -> viewer.status().state() == State.PLAYING && viewer.status().elapsedUs() > elapsed);
    viewer.click("play");
    viewer.waitFor("paused by click", () -> viewer.status().state() == State.PAUSED);
    // the button has the focus now, and Space must not press it a second time
    viewer.press(KeyCode.SPACE);
    viewer.waitFor("playing by key", () -> viewer.status().state() == State.PLAYING);
  }

  @Test
  void stepsMoveByOneSlice() throws IOException {
    openPausedAt(1_000_000);
    long start = viewer.status().elapsedUs();
    viewer.click("step-forward");
    viewer.waitFor("a step on", () -> viewer.status().elapsedUs() > start);
    long slice = viewer.status().sliceUs();
    assertEquals(start + slice, viewer.status().elapsedUs(), 1);
    viewer.press(KeyCode.PERIOD);
    viewer.waitFor("another step on", () -> viewer.status().elapsedUs() >= start + 2 * slice - 1);
    viewer.press(KeyCode.COMMA);
    viewer.click("step-back");
    viewer.waitFor("two steps back", () -> viewer.status().elapsedUs() <= start + 1);
    assertEquals(start, viewer.status().elapsedUs(), 2);
    assertEquals(State.PAUSED, viewer.status().state());
  }

  @Test
  void clickOnTheSeekBarSeeks() throws IOException {
    viewer = ViewerHarness.withRecording(folder, LENGTH_US);
    viewer.pause();
    viewer.click("seek-bar", 0.75, 0.5);
    viewer.waitFor("three quarters", () -> viewer.status().elapsedUs() > LENGTH_US / 2);
    assertEquals(0.75 * LENGTH_US, viewer.status().elapsedUs(), 0.01 * LENGTH_US);
    viewer.click("seek-bar", 0.25, 0.5);
    viewer.waitFor("one quarter", () -> viewer.status().elapsedUs() < LENGTH_US / 2);
    assertEquals(0.25 * LENGTH_US, viewer.status().elapsedUs(), 0.01 * LENGTH_US);
  }

  @Test
  void arrowsHomeAndEndSeek() throws IOException {
    viewer = ViewerHarness.withRecording(folder, LENGTH_US);
    viewer.pause();
    viewer.press(KeyCode.HOME);
    viewer.waitFor("the start", () -> viewer.status().elapsedUs() == 0);
    viewer.press(KeyCode.RIGHT);
    viewer.press(KeyCode.RIGHT);
    viewer.waitFor("two seconds on", () -> viewer.status().elapsedUs() == 2_000_000);
    viewer.press(KeyCode.LEFT);
    viewer.waitFor("one second back", () -> viewer.status().elapsedUs() == 1_000_000);
    long slice = viewer.status().sliceUs();
    viewer.press(KeyCode.END);
    viewer.waitFor("the end", () -> viewer.status().elapsedUs() > 3_900_000);
    viewer.waitFor("a whole slice", () -> viewer.status().sliceUs() >= slice - 1);
  }

  @Test
  void rewindSeeksToTheStartAndNotifiesSinks() {
    viewer = ViewerHarness.withBlob();
    List<StreamNotification> seen = new CopyOnWriteArrayList<>();
    viewer
        .session()
        .player()
        .addSink(
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {}

              @Override
              public void notified(StreamNotification notification) {
                seen.add(notification);
              }
            });
    viewer.pause();
    long before = viewer.status().elapsedUs();
    assertTrue(before > 0);
    viewer.press(KeyCode.R);
    viewer.waitFor("the start", () -> viewer.status().elapsedUs() == 0);
    viewer.waitFor("a rewind", () -> hasReset(seen, Reset.Cause.REWIND));
    viewer.press(KeyCode.Z);
    viewer.waitFor("a user reset", () -> hasReset(seen, Reset.Cause.USER));
  }

  private static boolean hasReset(List<StreamNotification> seen, Reset.Cause cause) {
    return seen.stream().anyMatch(item -> item instanceof Reset reset && reset.cause() == cause);
  }

  @Test
  void keysFAndSSelectTheNextSpeed() {
    viewer = ViewerHarness.withBlob();
    viewer.press(KeyCode.F);
    viewer.waitFor("twice as fast", () -> viewer.status().speed() == 2);
    assertEquals("2\u00d7", viewer.text("speed"));
    for (int i = 0; i < 3; i++) {
      viewer.press(KeyCode.S);
    }
    viewer.waitFor("a fifth as fast", () -> viewer.status().speed() == 0.2);
    assertEquals("1/5\u00d7", viewer.text("speed"));
    viewer.click("slower");
    viewer.click("slower");
    viewer.click("faster");
    viewer.waitFor("clicks count", () -> viewer.status().speed() == 0.1);
  }

  private void openPausedAt(long elapsedUs) throws IOException {
    viewer = ViewerHarness.withRecording(folder, LENGTH_US);
    viewer.pause();
    ViewerHarness.join(viewer.session().player().seek(elapsedUs));
  }

  @Test
  void backwardPlaybackContinuesUntilStopped() throws IOException {
    openPausedAt(2_000_000);
    viewer.click("play-backwards");
    viewer.waitFor("an earlier moment", () -> viewer.status().elapsedUs() < 1_900_000);
    viewer.waitFor("what it does", () -> viewer.text("status-message").endsWith("backwards"));
    viewer.click("play-backwards");
    viewer.waitFor("its stop", () -> !viewer.window.context().playback().reverseProperty().get());
    assertEquals(PlayerStatus.State.PAUSED, viewer.status().state());
  }

  @Test
  void backwardPlaybackShowsItsNumbersAndIsPausedBySpace() throws IOException {
    openPausedAt(3_000_000);
    viewer.waitFor("its time", () -> viewer.text("status-time").startsWith("t 3"));
    viewer.press(KeyCode.SHIFT, KeyCode.SPACE);
    viewer.waitFor("what it does", () -> viewer.text("status-message").endsWith("backwards"));
    viewer.waitFor("an earlier time", () -> viewer.text("status-time").startsWith("t 2"));
    assertNotEquals("0 ev/s", viewer.text("status-rate"));
    viewer.press(KeyCode.SPACE);
    viewer.waitFor("its stop", () -> viewer.text("status-message").endsWith("paused"));
    assertEquals(PlayerStatus.State.PAUSED, viewer.status().state());
  }

  @Test
  void zoomedBarFollowsAJumpInAPause() throws IOException {
    openPausedAt(2_000_000);
    Node needle = viewer.onFx(() -> viewer.node("seek-bar", Parent.class).lookup(".needle"));
    viewer.waitFor("the needle in the middle", () -> viewer.onFx(needle::getLayoutX) > 100);
    for (int i = 0; i < 4; i++) {
      viewer.wheel("seek-bar", 1);
    }
    viewer.press(KeyCode.HOME);
    viewer.waitFor("the start", () -> viewer.status().elapsedUs() == 0);
    viewer.waitFor(
        "the needle there", () -> needle.isVisible() && viewer.onFx(needle::getLayoutX) < 10);
  }

  @Test
  void endsOfTheMarkedPartStayInOrder() throws IOException {
    viewer = ViewerHarness.withRecording(folder, LENGTH_US);
    viewer.pause();
    PlaybackController playback = viewer.window.context().playback();
    viewer.run(
        () -> {
          playback.moveLoopEnd(true, 1_000_000);
          playback.moveLoopEnd(false, 2_000_000);
          playback.moveLoopEnd(true, 3_000_000);
        });
    assertEquals(
        OptionalLong.of(1_999_999), viewer.onFx(() -> playback.loopProperty().get()).inUs());
  }

  @Test
  void endOfTheMarkedPartIsDraggedInTheTimeBar() throws IOException {
    openPausedAt(3_000_000);
    PlaybackController playback = viewer.window.context().playback();
    viewer.run(
        () -> {
          playback.moveLoopEnd(true, 1_000_000);
          playback.moveLoopEnd(false, 2_000_000);
        });
    viewer.waitFor("the bar", () -> viewer.window.context().panels().seekBar().getWidth() > 100);
    viewer.drag("seek-bar", 0.25, 0.125);
    assertEquals(500_000, playback.loopProperty().get().inUs().getAsLong(), 0.01 * LENGTH_US);
    viewer.drag("seek-bar", 0.5, 0.625);
    assertEquals(2_500_000, playback.loopProperty().get().outUs().getAsLong(), 0.01 * LENGTH_US);
    assertEquals(3_000_000, viewer.status().elapsedUs(), "a handle does not seek");
  }

  @Test
  void disabledButtonsStateTheReason() {
    viewer = new ViewerHarness();
    Node loop = viewer.node("loop", Node.class);
    assertTrue(loop.isDisabled());
    assertEquals("Nothing is open.", viewer.onFx(() -> Controls.help(loop.getParent())));
    viewer.open(() -> new ScenePlayable(() -> new BlobSource(Long.MAX_VALUE), "blob"));
    viewer.waitFor("a button that works", () -> !loop.isDisabled());
    assertEquals("", viewer.onFx(() -> Controls.help(loop.getParent())));
  }

  @Test
  void loopPointsAndMarksAreSetAtThePlaybackPosition() throws IOException {
    openPausedAt(1_000_000);
    PlaybackController playback = viewer.window.context().playback();
    viewer.press(KeyCode.I);
    viewer.waitFor("its start", () -> playback.loopProperty().get().inUs().isPresent());
    ViewerHarness.join(viewer.session().player().seek(2_000_000));
    viewer.press(KeyCode.M);
    viewer.waitFor("the mark", () -> !playback.marks().isEmpty());
    viewer.click("mark-out");
    viewer.waitFor("its end", () -> playback.loopProperty().get().outUs().isPresent());
    Loop loop = viewer.onFx(() -> playback.loopProperty().get());
    assertEquals(OptionalLong.of(1_000_000), loop.inUs(), loop + " " + viewer.status());
    assertEquals(2_000_000 + viewer.status().sliceUs(), loop.outUs().getAsLong());
    assertEquals(List.of(new Mark("Mark 1", 2_000_000)), viewer.session().player().marks());
    viewer.press(KeyCode.J);
    viewer.press(KeyCode.R);
    viewer.waitFor("the loop's start", () -> viewer.status().elapsedUs() == 1_000_000);
    viewer.press(KeyCode.K);
    viewer.waitFor("the mark", () -> viewer.status().elapsedUs() == 2_000_000);
    viewer.press(KeyCode.L);
    viewer.waitFor("no loop", () -> !playback.loopProperty().get().on());
  }

  @Test
  void longNameOfAMarkIsShownInFullByTheMouse() throws IOException {
    String name = "landing of the second fly beside the first one";
    openPausedAt(1_000_000);
    viewer.run(() -> viewer.window.context().playback().mark(name));
    viewer.waitFor("the mark", () -> !viewer.session().player().marks().isEmpty());
    viewer.moveOver("seek-bar", 1_000_000 / (double) viewer.status().durationUs());
    SeekBar bar = viewer.node("seek-bar", SeekBar.class);
    viewer.waitFor(
        "its name", () -> bar.lookupAll(".label").stream().anyMatch(each -> isLabel(each, name)));
  }

  private static boolean isLabel(Node node, String end) {
    return node instanceof Label label && label.getText().endsWith(end);
  }

  @Test
  void slicesHaveTheSelectedTimeOrCount() {
    viewer = ViewerHarness.withBlob();
    ChoiceBox<?> mode = viewer.node("slicing", ChoiceBox.class);
    viewer.run(() -> mode.getSelectionModel().select(1));
    viewer.waitFor("slices of 20 ms", () -> viewer.status().sliceUs() == 20_000);
    TextField size = viewer.node("slice-size", TextField.class);
    viewer.run(
        () -> {
          size.requestFocus();
          size.setText("3000");
        });
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("slices of 3 ms", () -> viewer.status().sliceUs() == 3000);
    viewer.run(() -> mode.getSelectionModel().select(2));
    viewer.waitFor("a size for it", () -> size.getText().equals("5000"));
    PlaybackController playback = viewer.window.context().playback();
    assertEquals(new Slicing.ByCount(5000), viewer.onFx(() -> playback.slicingProperty().get()));
    viewer.run(
        () -> {
          size.requestFocus();
          size.setText("none");
        });
    viewer.press(KeyCode.ENTER);
    viewer.waitFor(
        "the entry is marked as wrong",
        () -> size.getPseudoClassStates().contains(Styles.STATE_DANGER));
    assertEquals(new Slicing.ByCount(5000), viewer.onFx(() -> playback.slicingProperty().get()));
  }
}
