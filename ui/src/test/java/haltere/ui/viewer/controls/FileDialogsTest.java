package haltere.ui.viewer.controls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileDialogsTest {
  @TempDir Path folder;
  private final FileDialogs dialogs = new FileDialogs(null);

  @Test
  void typedEndingIsNotFollowedByTheSuggestedOne() throws IOException {
    Path twice = folder.resolve("x.aedat4.aedat4");
    Path once = folder.resolve("x.aedat4");
    assertEquals(once, FileDialogs.withOneEnding(twice, "recording.aedat4", "*.aedat4"));
    Path film = folder.resolve("x.mp4.gif");
    assertEquals(
        folder.resolve("x.mp4"), FileDialogs.withOneEnding(film, "film.gif", "*.gif", "*.mp4"));
    for (Path whole : List.of(once, folder.resolve("x"), folder.resolve("x.2.aedat4"))) {
      assertEquals(whole, FileDialogs.withOneEnding(whole, "recording.aedat4", "*.aedat4"));
    }
    Files.createFile(once);
    assertEquals(twice, FileDialogs.withOneEnding(twice, "recording.aedat4", "*.aedat4"));
  }

  @Test
  void suggestedNamesBeginWithTheRecording() {
    assertEquals("picture.png", dialogs.suggested("picture.png"));
    dialogs.setSource("walk.2.aedat4");
    assertEquals("walk-2-picture.png", dialogs.suggested("picture.png"));
    dialogs.setSource("Fly scene");
    assertEquals("Fly-scene-picture.png", dialogs.suggested("picture.png"));
  }
}
