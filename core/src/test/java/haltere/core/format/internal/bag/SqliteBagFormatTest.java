package haltere.core.format.internal.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.luben.zstd.Zstd;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Support;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.RecordedPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** ROS 2 bags in SQLite keep the contract of all formats; their files are made here. */
class SqliteBagFormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new SqliteBagFormat();
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
  protected Support certainty() {
    return Support.PLAUSIBLE;
  }

  @Override
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    Files.write(file, SqliteBagFile.of(sensor, packets));
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    List<byte[]> lies = new ArrayList<>();
    for (int at = 16; at < 2560; at += 3) {
      byte[] copy = file.clone();
      ByteBuffer.wrap(copy).putInt(at, at % 2 == 0 ? -1 : Integer.MAX_VALUE);
      lies.add(copy);
    }
    return lies;
  }

  @Test
  void bagsOfAnotherProgramAreRead() throws IOException {
    Path file = Files.write(folder.resolve("a.db3"), BagResources.bytes("array.db3"));
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(List.of(), reader.violations().describe());
      assertEquals(List.of(), reader.remarks());
    }
    assertEquals(BagResources.events(), recorder.events());
  }

  @Test
  void individuallyCompressedMessagesAreRead() throws IOException {
    for (String name : new String[] {"array-packed.db3", "array-packed.mcap"}) {
      Path file = Files.write(folder.resolve(name), BagResources.bytes(name));
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(file, ReadOptions.DEFAULT.withPacketEvents(7))) {
        reader.drainTo(new StreamGrammar(recorder));
        assertEquals(List.of(), reader.violations().describe());
        assertEquals(BagResources.events(), recorder.events());
        StreamRecorder rest = new StreamRecorder();
        reader.seek(BagResources.events().timeUs(333));
        reader.drainTo(new StreamGrammar(rest));
        assertEquals(EventPackets.part(BagResources.events(), 333, 600), rest.events());
      }
    }
  }

  @Test
  void largeCompressedMessageIsDecompressedInPieces() throws IOException {
    int count = 400_000;
    EventPacket events = EventPackets.uniform(DAVIS346, 3, count, 0, 1.5);
    Path file = folder.resolve("large.db3");
    Files.write(file, SqliteBagFile.of(count, Zstd::compress, DAVIS346, events));
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(List.of(), reader.violations().describe());
    }
    assertEquals(events, recorder.events());
  }

  @Test
  void messagesInTheWriteAheadLogAreReported() throws IOException {
    Path file = Files.write(folder.resolve("b.db3"), BagResources.bytes("array.db3"));
    Files.write(folder.resolve("b.db3-wal"), new byte[100]);
    try (RecordingReader reader = Recordings.open(file)) {
      assertTrue(reader.remarks().get(0).contains("b.db3-wal"), reader.remarks().toString());
    }
  }

  @Test
  void damagedFilesAreReadOrRejected() throws IOException {
    assertReadable("array.db3", 9);
    assertReadable("array-packed.db3", 10);
  }

  private void assertReadable(String name, long seed) throws IOException {
    byte[] whole = BagResources.bytes(name);
    SplittableRandom random = new SplittableRandom(seed);
    Path file = folder.resolve("fuzz.db3");
    int read = 0;
    for (int i = 0; i < 300; i++) {
      byte[] bytes = whole.clone();
      for (int flips = 1 + random.nextInt(6); flips > 0; flips--) {
        bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
      }
      ReplacedFile.write(file, bytes);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          new SqliteBagFormat().open(file, ReadOptions.DEFAULT.withPacketEvents(40))) {
        reader.drainTo(new StreamGrammar(recorder));
        reader.seek(5_000);
        read += recorder.events().isEmpty() ? 0 : 1;
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
    assertTrue(read > 100, read + " of the files gave events");
  }

  /** As a script with Python's sqlite3 finds them among the words. */
  @Test
  void triggersOfARecordedBagAreRead() throws IOException {
    StreamRecorder stream = new StreamRecorder();
    ReadOptions withSamples = ReadOptions.DEFAULT.withSamples(true);
    try (RecordingReader reader = RecordedPackets.TRIGGERS_BAG.open(withSamples)) {
      reader.drainTo(new StreamGrammar(stream));
    }
    assertEquals(
        List.of(
            new Trigger(14_547_491, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING, 0),
            new Trigger(14_549_491, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0)),
        stream.samples(Trigger.class));
  }
}
