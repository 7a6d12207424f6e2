package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.RecordingFile;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.FileWindow;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Search for packets in a damaged file. */
class PacketWalkTest {
  private static final int PACKETS = 20_000;

  @TempDir Path folder;

  @Test
  void walkOverEmptyPacketsTakesLinearTime() throws IOException {
    int bytes = PACKETS * PacketWalk.HEADER_BYTES;
    Path file = Files.write(folder.resolve("empty"), new byte[bytes]);
    try (RecordingFile recording = new RecordingFile(file)) {
      PacketWalk walk =
          new PacketWalk(
              new FileWindow(recording), Set.of(0), 0, bytes, false, new ViolationCounts());
      int packets = 0;
      while (walk.find()) {
        assertEquals(0, walk.size());
        walk.passDamaged();
        packets++;
      }
      assertEquals(PACKETS, packets);
      assertTrue(walk.looks() <= 4L * bytes, walk.looks() + " looks");
    }
  }
}
