package haltere.core.format.internal.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** MCAP files keep the contract of all formats, as we write them and as others do. */
class McapFormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new McapFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(DAVIS346, new SensorGeometry(1, 1), new SensorGeometry(32768, 32768));
  }

  @Override
  protected long earliestUs() {
    return -latestUs();
  }

  @Override
  protected long latestUs() {
    return (1L << 31) * 1_000_000 - 1;
  }

  @Override
  protected boolean endsInEvents() {
    return false;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    List<byte[]> lies = new ArrayList<>();
    for (int at = 8; at < file.length - 8; at++) {
      if (at > 120 && at < file.length - 900) {
        continue;
      }
      byte[] copy = file.clone();
      ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN).putLong(at, 1L << 31);
      lies.add(copy);
    }
    return lies;
  }

  private EventPacket read(byte[] bytes, int packetEvents) throws IOException {
    Path file = Files.write(folder.resolve("made.mcap"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withPacketEvents(packetEvents))) {
      assertEquals("mcap", reader.formatName());
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(List.of(), reader.violations().describe());
    }
    return recorder.events();
  }

  @Test
  void filesOfAnotherProgramAreRead() throws IOException {
    for (String name :
        new String[] {"array-zstd.mcap", "libcaer_cmp-lz4.mcap", "libcaer-flat.mcap"}) {
      for (int packetEvents : new int[] {1, 8192}) {
        assertEquals(BagResources.events(), read(BagResources.bytes(name), packetEvents), name);
      }
    }
  }

  @Test
  void chunkAfterADamagedOneIsRead() throws IOException {
    byte[] bytes = BagResources.bytes("array-zstd.mcap");
    List<Integer> chunks = new ArrayList<>();
    for (int at = McapIndex.FIRST_RECORD; bytes[at] != McapRecord.DATA_END; ) {
      if (bytes[at] == McapRecord.CHUNK) {
        chunks.add(at);
      }
      at += 9 + (int) ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getLong(at + 1);
    }
    int first = chunks.get(0);
    EventPacket events = BagResources.events();
    // The kind, the compression, and a high byte of the length.
    for (int damagedAt : new int[] {first, first + 41, first + 51}) {
      byte[] damaged = bytes.clone();
      damaged[damagedAt] = 0x7e;
      Path file = ReplacedFile.write(folder.resolve("damaged.mcap"), damaged);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader = Recordings.open(file)) {
        reader.drainTo(new StreamGrammar(recorder));
        assertTrue(
            reader.violations().count(Violation.IMPOSSIBLE_LENGTH)
                    + reader.violations().count(Violation.UNKNOWN_WORD)
                    + reader.violations().count(Violation.DAMAGED_PACKET)
                > 0);
      }
      EventPacket got = recorder.events();
      int lost = events.size() - got.size();
      assertTrue(lost > 0 && lost < 400, "lost " + lost);
      assertEquals(events.lastTimeUs(), got.lastTimeUs());
    }
  }

  @Test
  void timesBeyondTheRangeOfMessagesAreRejected() throws IOException {
    for (long timeUs : new long[] {earliestUs() - 1, latestUs() + 1}) {
      EventPacket events = new EventPacket(1);
      events.append(timeUs, 0, 0, true);
      Path file = folder.resolve("far.mcap");
      try (RecordingWriter writer =
          new McapFormat().create(file, WriteOptions.of(DAVIS346)).orElseThrow()) {
        RecordingProblem problem = assertThrows(RecordingProblem.class, () -> writer.write(events));
        assertTrue(problem.getMessage().contains("68 years"), problem.getMessage());
      }
    }
  }

  @Test
  void damagedFilesAreReadOrRejected() throws IOException {
    List<byte[]> wholes =
        List.of(
            BagResources.bytes("array-zstd.mcap"),
            BagResources.bytes("libcaer_cmp-lz4.mcap"),
            BagResources.bytes("libcaer-flat.mcap"));
    SplittableRandom random = new SplittableRandom(9);
    Path file = folder.resolve("fuzz.mcap");
    int read = 0;
    for (int i = 0; i < 400; i++) {
      byte[] bytes = wholes.get(i % wholes.size()).clone();
      for (int flips = 1 + random.nextInt(6); flips > 0; flips--) {
        bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
      }
      if (random.nextInt(3) == 0) {
        bytes = Arrays.copyOf(bytes, random.nextInt(bytes.length));
      }
      ReplacedFile.write(file, bytes);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          new McapFormat().open(file, ReadOptions.DEFAULT.withPacketEvents(40))) {
        reader.drainTo(new StreamGrammar(recorder));
        reader.seek(5_000);
        read += recorder.events().isEmpty() ? 0 : 1;
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
    assertTrue(read > 200, read + " of the files gave events");
  }
}
