package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The window goes on while files are opened, sought and exported. */
class UiBlocksTest {
  @TempDir Path folder;

  @Test
  void nothingKeepsTheWindowForMoreThanFiftyMilliseconds() throws IOException {
    Path recording = folder.resolve("long.aedat");
    ViewerHarness.writeRecording(recording, 10_000_000);
    try (ViewerHarness viewer = new ViewerHarness()) {
      // once before: what classes cost when they are first used is the start's
      UiBlocks.work(viewer, recording, folder.resolve("first.aedat4"));
      try (UiBlocks blocks = new UiBlocks()) {
        UiBlocks.work(viewer, recording, folder.resolve("second.aedat4"));
        assertTrue(
            blocks.longestCpuMs() <= 50, "a block of " + blocks.longestCpuMs() + " ms of CPU time");
      }
    }
  }
}
