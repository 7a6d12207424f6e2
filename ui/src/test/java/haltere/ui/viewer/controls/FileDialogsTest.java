package haltere.ui.viewer.controls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class FileDialogsTest {
  private final FileDialogs dialogs = new FileDialogs(null);

  @Test
  void suggestedNamesBeginWithTheRecording() {
    assertEquals("picture.png", dialogs.suggested("picture.png"));
    dialogs.setSource("walk.2.aedat4");
    assertEquals("walk-2-picture.png", dialogs.suggested("picture.png"));
    dialogs.setSource("Fly scene");
    assertEquals("Fly-scene-picture.png", dialogs.suggested("picture.png"));
  }
}
