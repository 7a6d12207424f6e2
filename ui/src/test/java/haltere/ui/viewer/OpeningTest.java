package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.ReadOptions;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.viewer.feature.Sessions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javafx.beans.InvalidationListener;
import javafx.scene.Parent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** From one recording to the next, which the window comes to in steps. */
class OpeningTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    viewer.close();
  }

  private int filters() {
    return viewer.session().chain().stages().size();
  }

  private List<String> cards() {
    return viewer.onFx(
        () ->
            viewer.stage.getScene().getRoot().lookup(".cards").lookupAll(".stage").stream()
                .map(card -> card.getId().substring("stage-".length()))
                .toList());
  }

  @Test
  void filtersAppearOneByOneBeforePlaybackStarts() throws IOException {
    viewer = ViewerHarness.withBlob();
    Path next = ViewerHarness.recording(folder, "next.aedat");
    viewer.openRecording(next);
    viewer.addNoiseFilters();
    viewer.openRecording(ViewerHarness.recording(folder, "other.aedat"));
    List<Integer> cardsShown = new ArrayList<>();
    Parent list = (Parent) viewer.onFx(() -> viewer.stage.getScene().lookup(".cards"));
    InvalidationListener counter = changed -> cardsShown.add(list.getChildrenUnmodifiable().size());
    viewer.run(() -> list.getChildrenUnmodifiable().addListener(counter));
    viewer.openRecording(next);
    assertTrue(filters() > 1);
    List<Integer> wanted = new ArrayList<>();
    for (int i = 0; i <= filters(); i++) {
      wanted.add(i);
    }
    assertEquals(wanted, viewer.onFx(() -> List.copyOf(cardsShown)));
  }

  @Test
  void lastOfTwoOpenedSourcesIsShownWithItsFilters() throws IOException {
    viewer = ViewerHarness.withBlob();
    Path first = ViewerHarness.recording(folder, "first.aedat");
    Path last = ViewerHarness.recording(folder, "last.aedat");
    onNextSession(() -> viewer.window.context().sessions().open(last, ReadOptions.DEFAULT));
    viewer.run(() -> viewer.window.context().sessions().open(first, ReadOptions.DEFAULT));
    viewer.waitUntilOpen("last.aedat");
    assertEquals(
        viewer.session().chain().stages().stream().map(stage -> stage.name()).toList(), cards());
  }

  @Test
  void pauseBeforeTheStartRemains() throws IOException {
    viewer = ViewerHarness.withBlob();
    onNextSession(viewer.window.context().playback()::togglePause);
    Path file = ViewerHarness.recording(folder, "next.aedat");
    viewer.run(() -> viewer.window.context().sessions().open(file, ReadOptions.DEFAULT));
    viewer.waitFor(
        "the recording",
        () -> viewer.window.context().sessions().session().get().request().file().isPresent());
    // taken by the player once it has begun
    ViewerHarness.join(viewer.session().player().edit(chain -> {}));
    assertEquals(State.PAUSED, viewer.status().state());
    assertEquals(filters(), cards().size());
  }

  @Test
  void minimizedWindowPlaysAnOpenedSource() throws IOException {
    viewer = ViewerHarness.withBlob();
    viewer.run(() -> viewer.stage.setIconified(true));
    viewer.waitFor("minimized", viewer.stage::isIconified);
    viewer.openRecording(ViewerHarness.recording(folder, "next.aedat"));
    viewer.waitFor("playback", () -> viewer.status().elapsedUs() > 500_000);
    viewer.run(() -> viewer.stage.setIconified(false));
    assertEquals(filters(), cards().size());
  }

  /** Does something, once, when something else has just been opened. */
  private void onNextSession(Runnable action) {
    AtomicReference<Runnable> next = new AtomicReference<>(action);
    Sessions sessions = viewer.window.context().sessions();
    viewer.run(() -> sessions.onChange((was, is) -> next.getAndSet(() -> {}).run()));
  }
}
