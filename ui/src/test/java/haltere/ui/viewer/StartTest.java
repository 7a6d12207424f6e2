package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.ReadOptions;
import haltere.ui.plot.Lane;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.FutureTask;
import javafx.scene.Node;
import javafx.scene.layout.Region;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The first minute: the start page, the fly, the manual. */
class StartTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @BeforeEach
  void openWindow() {
    viewer = new ViewerHarness();
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private void showStartPage() {
    viewer.run(() -> viewer.window.context().actions().run("start-page"));
    // what is inside of it can be found once it was laid out
    viewer.waitFor("the start page", () -> viewer.isThere("start-scene-fly"));
  }

  @Test
  void startPageOffersScenesAndRecentRecordings() throws IOException {
    showStartPage();
    for (String scene : List.of("fly", "road", "dots", "flight", "rendered-fly")) {
      assertTrue(viewer.isThere("start-scene-" + scene), scene);
      assertTrue(
          StartTest.class.getResource("/haltere/ui/viewer/start/scene-" + scene + ".png") != null,
          scene);
    }
    viewer.click("start-scene-dots");
    viewer.waitUntilOpen("Dots scene");
    assertFalse(viewer.isThere("start-page"));
    Path file = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(file, 500_000);
    viewer.openRecording(file);
    showStartPage();
    viewer.waitFor("the way back", () -> viewer.isThere("start-back"));
    assertEquals("Back to blob.aedat", viewer.text("start-back"));
    assertEquals("blob.aedat", viewer.text("start-recent-1"));
    viewer.click("start-back");
    viewer.waitFor("the recording again", () -> !viewer.isThere("start-page"));
  }

  @Test
  void longNameOfARecentRecordingDoesNotWidenThePage() throws IOException {
    Path file = ViewerHarness.recording(folder, "long-name-".repeat(20) + ".aedat");
    viewer.openRecording(file);
    showStartPage();
    viewer.waitFor("the name", () -> viewer.isThere("start-recent-1"));
    double width = viewer.node("start-page", Region.class).getWidth();
    viewer.waitFor(
        "a page within the window",
        () -> viewer.node("start-recent-1", Region.class).getWidth() < width);
  }

  @Test
  void clickDuringTheCameraSearchIsProcessed() throws IOException {
    Path file = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(file, 500_000);
    viewer.openRecording(file);
    showStartPage();
    for (String id : List.of("start-scene-dots", "start-recent-1")) {
      Node before = viewer.node(id, Node.class);
      viewer.run(() -> viewer.window.context().actions().offer("cameras", List.of()));
      assertSame(before, viewer.node(id, Node.class), "a button that is pressed is let go there");
    }
  }

  @Test
  void unreadableFileAtTheStartShowsTheStartPageWithTheFullReason() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    FutureTask<ViewerSession> first =
        new FutureTask<>(
            () ->
                SessionRequest.recording(empty, ReadOptions.DEFAULT)
                    .firstSession(Optional.empty()));
    first.run();
    viewer.run(() -> viewer.window.context().sessions().open(first, empty.toString()));
    // what is inside of it can be found once it was laid out
    viewer.waitFor("the start page", () -> viewer.isThere("start-scene-fly"));
    assertEquals(
        empty + " cannot be opened.\nThe file is empty; record or copy it again",
        viewer.text("start-problem"));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1})
  void speedSelectedDuringTheFlySearchRemains(double chosen) {
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    viewer.run(() -> viewer.window.context().playback().setSpeed(chosen));
    viewer.waitFor("the end of the search", () -> viewer.status().elapsedUs() > 200_000);
    viewer.waitFor("a picture", () -> viewer.window.context().panels().framesShown() > 1);
    assertEquals(chosen, viewer.onFx(viewer.window.context().playback().speedProperty()::get));
  }

  @Test
  void flySceneStartsInSlowMotionWithACaptionDismissedByAClick() throws IOException {
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    viewer.waitFor(
        "slow motion",
        () -> viewer.onFx(viewer.window.context().playback().speedProperty()::get) == 0.01);
    assertTrue(viewer.isThere("fly-caption"));
    assertTrue(viewer.text("fly-caption").contains("orange: brighter (ON), blue: darker (OFF)"));
    viewer.run(() -> viewer.window.context().actions().run("show-as-frequency"));
    assertEquals("Simulated tethered fly, seen from above", viewer.text("fly-caption"));
    assertEquals(
        100_000, viewer.onFx(() -> viewer.window.context().panels().plots().window().spanUs()));
    List<Lane> lanes = viewer.onFx(() -> viewer.window.context().panels().plots().lanes());
    assertEquals(2, lanes.size());
    viewer.click("fly-caption");
    viewer.waitFor("no caption", () -> !viewer.isThere("fly-caption"));
    Path file = folder.resolve("blob.aedat");
    ViewerHarness.writeRecording(file, 500_000);
    viewer.openRecording(file);
    viewer.waitFor(
        "the speed of before",
        () -> viewer.onFx(viewer.window.context().playback().speedProperty()::get) == 1);
  }

  @Test
  void manualAndAboutPageAreShown() {
    viewer.run(() -> viewer.window.context().actions().run("manual"));
    viewer.waitFor("the manual", () -> viewer.isThere("manual"));
    viewer.run(() -> viewer.node("manual", Node.class).getScene().getWindow().hide());
    viewer.run(() -> viewer.window.context().actions().run("about"));
    viewer.waitFor("the facts", () -> viewer.isThere("about"));
    String facts = viewer.text("about");
    assertTrue(facts.contains("Apache-2.0") && facts.contains(System.getProperty("java.vendor")));
    viewer.run(() -> viewer.node("about", Node.class).getScene().getWindow().hide());
  }

  @Test
  void manualIsShownWithoutMarkup() {
    assertEquals(
        "Open a file by Ctrl+O, see formats.",
        Manual.plain("**Open** a file\nby `Ctrl+O`, see [formats](formats.md).\n![x](y.png)"));
    assertEquals(4, viewer.onFx(() -> Manual.nodes("# Title\n\nWords\n\n- one\n- two\n").size()));
  }
}
