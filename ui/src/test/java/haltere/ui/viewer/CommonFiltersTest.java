package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.playback.PlayerStatus;
import haltere.ui.viewer.feature.UserSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Recordings are raw at first, buttons switch the usual filters, and each has its own chain. */
class CommonFiltersTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private List<String> kinds() {
    // behind all changes that were asked for
    ViewerHarness.join(viewer.session().player().edit(chain -> {}));
    return viewer.session().chain().stages().stream().map(ChainStage::kind).toList();
  }

  private boolean isOn(String button) {
    ToggleButton toggle = viewer.node(button, ToggleButton.class);
    return viewer.onFx(toggle::isSelected);
  }

  @Test
  void recordingOpensWithoutFiltersAndShowsAllEvents() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    assertEquals(List.of(), kinds());
    PlayerStatus status = viewer.status();
    assertEquals(status.eventsIn(), status.eventsOut());
    assertFalse(isOn("usual-denoise") || isOn("usual-objects") || isOn("usual-wings"));
    assertFalse(viewer.node("hidden-events", javafx.scene.Node.class).isVisible());
  }

  @Test
  void buttonsToggleTheirFiltersAndUndoRemovesThem() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.click("usual-objects");
    viewer.waitFor("the object tracker", () -> isOn("usual-objects"));
    viewer.click("usual-denoise");
    viewer.waitFor("noise filters", () -> isOn("usual-denoise"));
    assertEquals(List.of("background-activity", "hot-pixels", "object-tracker"), kinds());
    viewer.click("usual-denoise");
    viewer.waitFor("no noise filters", () -> !isOn("usual-denoise"));
    assertEquals(
        List.of(false, false, true),
        viewer.session().chain().stages().stream().map(ChainStage::isEnabled).toList());
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("noise filters again", () -> isOn("usual-denoise"));
  }

  @Test
  void switchOfACardUpdatesTheButton() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.click("usual-objects");
    viewer.waitFor("the card", () -> viewer.isThere("power-object-tracker"));
    viewer.waitFor("the button", () -> isOn("usual-objects"));
    viewer.click("power-object-tracker");
    viewer.waitFor("the button is off", () -> !isOn("usual-objects"));
  }

  @Test
  void shareOfHiddenEventsIsStatedAndTheyCanBeShown() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 4_000_000);
    FilterChain refractory = new FilterChain(BlobSource.GEOMETRY);
    refractory.add(Filters.named("refractory"));
    viewer.run(() -> viewer.window.context().editor().replaceAll(refractory));
    viewer.waitFor("the share", () -> viewer.text("hidden-events").endsWith("%\nhidden"));
    viewer.waitFor(
        "the note", () -> viewer.node("hidden-events", javafx.scene.Node.class).isVisible());
    viewer.click("hidden-events");
    viewer.waitFor("the words", () -> viewer.text("hidden-events").endsWith("%\nshown"));
    viewer.click("hidden-events");
    viewer.waitFor("hidden again", () -> viewer.text("hidden-events").endsWith("hidden"));
  }

  @Test
  void shareOfHiddenEventsIsStatedDuringAPause() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 4_000_000);
    viewer.waitFor("some events", () -> viewer.status().elapsedUs() > 500_000);
    viewer.pause();
    FilterChain refractory = new FilterChain(BlobSource.GEOMETRY);
    refractory.add(Filters.named("refractory"));
    viewer.run(() -> viewer.window.context().editor().replaceAll(refractory));
    viewer.waitFor("the share", () -> viewer.text("hidden-events").endsWith("%\nhidden"));
  }

  @Test
  void pauseBeforeTheFirstConfirmedObjectStatesTheConfirmationTime() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 4_000_000);
    viewer.pause();
    viewer.run(() -> ViewerHarness.join(viewer.session().player().seek(100_000)));
    viewer.click("usual-objects");
    Label note = viewer.node("filter-status", Label.class);
    viewer.waitFor("the note", note::isVisible);
    assertEquals(
        "No objects yet: an object is confirmed after 0.3 s of motion.",
        viewer.text("filter-status"));
    viewer.run(() -> ViewerHarness.join(viewer.session().player().seek(1_500_000)));
    viewer.waitFor("an object", () -> !note.isVisible());
    viewer.click("usual-objects");
    viewer.click("usual-wings");
    viewer.waitFor("another note", note::isVisible);
    assertEquals("Waits for wings.", viewer.text("filter-status"));
  }

  @Test
  void addedFilterIsKeptWhenTheWindowIsClosedNext() throws IOException {
    Path file = ViewerHarness.recording(folder, "first.aedat");
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    viewer.openRecording(file);
    viewer.pause();
    viewer.click("usual-objects");
    viewer.waitFor("its chain", () -> !viewer.onFx(() -> settings.map("chains")).isEmpty());
    viewer.close();
    settings.save();
    viewer = new ViewerHarness(UserSettings.load(folder));
    viewer.openRecording(file);
    assertEquals(List.of("object-tracker"), kinds());
  }

  @Test
  void eachRecordingKeepsItsOwnChainAcrossWindows() throws IOException {
    Path first = ViewerHarness.recording(folder, "first.aedat");
    Path second = ViewerHarness.recording(folder, "second.aedat");
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    viewer.openRecording(first);
    viewer.click("usual-denoise");
    viewer.waitFor("noise filters", () -> isOn("usual-denoise"));
    viewer.openRecording(second);
    assertEquals(List.of(), kinds());
    viewer.openRecording(first);
    assertEquals(List.of("background-activity", "hot-pixels"), kinds());
    viewer.close();
    settings.save();
    viewer = new ViewerHarness(UserSettings.load(folder));
    viewer.openRecording(first);
    assertEquals(List.of("background-activity", "hot-pixels"), kinds());
  }

  @Test
  void savedChainWithoutItsExtensionIsReportedAndKept() throws IOException {
    Path file = ViewerHarness.recording(folder, "first.aedat");
    Path other = ViewerHarness.recording(folder, "second.aedat");
    UserSettings settings = UserSettings.load(folder);
    Map<String, Object> chains =
        Map.of(file.toString(), Map.of("filters", List.of(Map.of("filter", "gone"))));
    settings.put("chains", chains);
    viewer = new ViewerHarness(settings);
    viewer.openRecording(file);
    viewer.waitFor(
        "why it is not used",
        () -> viewer.text("status-message").contains("there is no filter named gone"));
    viewer.openRecording(other);
    assertEquals(chains, settings.map("chains"));
  }

  @Test
  void flySceneHasItsWingTrackerAndUsualChainRestoresIt() throws IOException {
    viewer = new ViewerHarness();
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    List<String> usual = kinds();
    assertTrue(usual.contains("wing-tracker"), usual.toString());
    ChainStage tracker = viewer.session().chain().stages().get(usual.indexOf("wing-tracker"));
    viewer.run(() -> viewer.window.context().editor().remove(tracker));
    viewer.waitFor("no wing tracker", () -> !kinds().contains("wing-tracker"));
    viewer.run(() -> viewer.window.context().actions().run("usual-chain"));
    viewer.waitFor("the usual chain", () -> kinds().equals(usual));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("no wing tracker", () -> !kinds().contains("wing-tracker"));
    viewer.openRecording(ViewerHarness.recording(folder, "other.aedat"));
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    assertEquals(usual, kinds());
  }
}
