package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Opening of files, and reading of streams, which cannot be reopened. */
class RecordingFileTest {
  private static final int BYTES = 5_000_000;
  private static final int PIECE = 60_000;

  private final byte[] bytes = new byte[BYTES];

  private RecordingFile stream() {
    new SplittableRandom(1).nextBytes(bytes);
    return RecordingFile.stream(Path.of("-"), Channels.newChannel(new ByteArrayInputStream(bytes)));
  }

  @Test
  void streamIsReadForwardsWithShortBackwardSeeks() throws IOException {
    try (RecordingFile stream = stream()) {
      assertEquals(Long.MAX_VALUE, stream.size());
      int offset = 0;
      while (offset < BYTES) {
        byte[] piece = stream.read(offset, PIECE);
        byte[] expected = Arrays.copyOfRange(bytes, offset, Math.min(BYTES, offset + PIECE));
        assertArrayEquals(expected, piece);
        offset += PIECE - 100;
      }
      assertEquals(BYTES, stream.size());
      String refused = assertThrows(RecordingProblem.class, () -> stream.read(0, 10)).getMessage();
      assertTrue(refused.contains("a stream is read only once"), refused);
    }
  }

  @Test
  void readingBehindTheEndOfAStreamYieldsNothing() throws IOException {
    try (RecordingFile stream = stream()) {
      assertEquals(0, stream.read(BYTES + 3_000_000_000L, 10).length);
      assertEquals(5, stream.read(BYTES - 5, 10).length);
    }
  }

  @Test
  void closedFileIsNamed(@TempDir Path folder) throws IOException {
    Path path = Files.write(folder.resolve("closed.bin"), new byte[8]);
    RecordingFile file = new RecordingFile(path);
    file.close();
    RecordingProblem problem =
        assertThrows(RecordingProblem.class, () -> file.read(ByteBuffer.allocate(8), 0));
    assertEquals(path + ": it was closed before", problem.getMessage());
  }

  @Test
  void interruptWhileAFileIsOpenedIsToldAsOne(@TempDir Path folder) throws IOException {
    Path file = Files.write(folder.resolve("any.raw"), bytes);
    Thread.currentThread().interrupt();
    assertThrows(InterruptedIOException.class, () -> new RecordingFile(file));
    assertTrue(Thread.interrupted(), "the thread stays interrupted");
  }
}
