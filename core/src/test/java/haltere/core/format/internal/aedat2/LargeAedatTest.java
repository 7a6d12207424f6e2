package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.TimeSegment;
import haltere.core.stream.StreamStarted;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A file larger than an int can count; most of it is a hole, which reads as events at time 0. */
class LargeAedatTest {
  private static final long HOLE_RECORDS = (Integer.MAX_VALUE + 50_000_000L) / 8;

  @TempDir Path folder;

  @Test
  void recordingOfMoreThanTwoGigabytesIsReadAndSeekable() throws IOException {
    byte[] start = AedatFile.version2().text("# AEChip: x.DVS128\r\n").toBytes();
    AedatFile end = AedatFile.empty();
    for (int i = 0; i < 1000; i++) {
      end.dvs128(5000 + i, i % 128, 7, true);
    }
    Path file = Files.write(folder.resolve("large.aedat"), start);
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
      channel.write(ByteBuffer.wrap(end.toBytes()), start.length + 8 * HOLE_RECORDS);
    }
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withPacketEvents(1 << 16))) {
      assertEquals(List.of(new TimeSegment(0, 5999)), reader.segments());
      StreamRecorder tail = new StreamRecorder();
      reader.seek(5400);
      reader.drainTo(tail);
      assertEquals(600, tail.events().size());
      assertEquals(5400, tail.events().firstTimeUs());
      assertEquals(reader.sizeBytes(), reader.positionBytes());
      assertEquals(1, tail.notifications(StreamStarted.class).size());
    }
  }
}
