package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The window goes on while files are opened, sought and exported. */
class UiBlocksTest {
  private static final int BLOCK_EVENTS = 1 << 17;
  private static final int BLOCKS = 1024;

  @TempDir Path folder;

  @Test
  void gigabyteFileBlocksTheWindowForLessThan50Ms() throws IOException {
    assumeTrue(
        Files.getFileStore(folder).getUsableSpace() > 4L << 30,
        "the disk has no 4 GB free for a file of 1 GB and its copies");
    Path small = folder.resolve("small.aedat");
    ViewerHarness.writeRecording(small, 2_000_000);
    Path large = folder.resolve("large.aedat");
    writeGigabyte(large);
    try (ViewerHarness viewer = new ViewerHarness()) {
      // once before: what classes cost when they are first used is the start's
      UiBlocks.work(viewer, small, folder.resolve("first.aedat4"));
      try (UiBlocks blocks = new UiBlocks()) {
        UiBlocks.work(viewer, large, folder.resolve("second.aedat4"));
        assertTrue(
            blocks.longestCpuMs() <= 50, "a block of " + blocks.longestCpuMs() + " ms of CPU time");
      }
    }
  }

  /** AEDAT-2 of a DVS128: an event in each microsecond, 134 seconds long. */
  private static void writeGigabyte(Path file) throws IOException {
    ByteBuffer block = ByteBuffer.allocate(8 * BLOCK_EVENTS);
    long[] words = new long[BLOCK_EVENTS];
    try (OutputStream out = Files.newOutputStream(file)) {
      out.write("#!AER-DAT2.0\r\n".getBytes(StandardCharsets.US_ASCII));
      for (int i = 0; i < BLOCKS; i++) {
        for (int k = 0; k < BLOCK_EVENTS; k++) {
          int timeUs = i * BLOCK_EVENTS + k;
          // rows and columns are walked in big steps, so that the picture is full
          words[k] = (long) (timeUs * 2654435 >>> 6 & 0x7fff) << 32 | timeUs;
        }
        block.asLongBuffer().put(words);
        out.write(block.array());
      }
    }
  }
}
