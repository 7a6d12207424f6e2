package haltere.core.format.internal.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.Trigger;
import haltere.core.format.RandomSamples;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** ROS 1 bags keep the contract of all formats; their files are made here, from the layout. */
class RosbagFormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260, Origin.TOP);
  private static final String ARRAY = "dvs_msgs/EventArray";
  private static final String PACKET = "event_camera_msgs/EventPacket";

  @Override
  protected RecordingFormat format() {
    return new RosbagFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(DAVIS346, new SensorGeometry(1, 1), new SensorGeometry(32768, 32768));
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return 0xffff_ffffL * 1_000_000 + 999_999;
  }

  @Override
  protected boolean endsInEvents() {
    return false;
  }

  private static RosbagFile bag(SensorGeometry sensor, EventPacket... packets) {
    RosbagFile bag = new RosbagFile().topic("/dvs/events", ARRAY).topic("/talk", "std_msgs/String");
    for (EventPacket packet : packets) {
      for (int from = 0; from < packet.size(); from += 900) {
        EventPacket part = EventPackets.part(packet, from, Math.min(from + 900, packet.size()));
        bag.message(1, new RosBytes(false).text("nothing of interest").toBytes());
        bag.message(0, RosBytes.array(false, sensor, part));
        if (from / 900 % 4 == 3) {
          bag.endChunk();
        }
      }
    }
    return bag.endChunk();
  }

  @Override
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    Files.write(file, bag(sensor, packets).closed());
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    List<byte[]> lies = new ArrayList<>();
    for (int at = 0; at < file.length; at = at == 120 ? 4100 : at + 1) {
      if (at > 4500 && at < file.length - 400) {
        continue;
      }
      for (int lie : new int[] {-1, 1 << 20}) {
        byte[] copy = file.clone();
        ByteBuffer.wrap(copy)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(Math.min(at, file.length - 4), lie);
        lies.add(copy);
      }
    }
    return lies;
  }

  private EventPacket read(byte[] bytes, ReadOptions options) throws IOException {
    Path file = Files.write(folder.resolve("made.bag"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, options)) {
      assertEquals("rosbag", reader.formatName());
      reader.drainTo(new StreamGrammar(recorder));
    }
    return recorder.events();
  }

  private EventPacket read(byte[] bytes) throws IOException {
    return read(bytes, ReadOptions.DEFAULT);
  }

  @Test
  void allCompressionsAndEncodingsOfAnotherProgramAreRead() throws IOException {
    for (String name :
        new String[] {
          "array-lz4.bag", "array-bz2.bag", "mono.bag", "libcaer.bag", "libcaer_cmp.bag"
        }) {
      for (int packetEvents : new int[] {1, 8192}) {
        assertEquals(
            BagResources.events(),
            read(BagResources.bytes(name), ReadOptions.DEFAULT.withPacketEvents(packetEvents)),
            name);
      }
    }
  }

  @Test
  void unclosedBagsAreReadToTheirEnd() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS346, 1, 9000, 4_000, 30);
    Path file = Files.write(folder.resolve("live.bag"), bag(DAVIS346, events).open());
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(1, reader.violations().count(Violation.CUT_OFF));
    }
    assertEquals(events, recorder.events());
  }

  @Test
  void firstTopicWithEventsIsReadAndOthersAreReported() throws IOException {
    EventPacket left = EventPackets.uniform(DAVIS346, 2, 500, 4_000, 30);
    EventPacket right = EventPackets.uniform(DAVIS346, 3, 400, 4_000, 30);
    byte[] bytes =
        new RosbagFile()
            .topic("/empty", ARRAY)
            .topic("/left", ARRAY)
            .topic("/right", ARRAY)
            .message(0, RosBytes.array(false, DAVIS346, new EventPacket(0)))
            .message(1, RosBytes.array(false, DAVIS346, left))
            .message(2, RosBytes.array(false, DAVIS346, right))
            .endChunk()
            .closed();
    assertEquals(left, read(bytes));
    assertEquals(right, read(bytes, ReadOptions.DEFAULT.withTopic("/right")));
    try (RecordingReader reader = Recordings.open(folder.resolve("made.bag"))) {
      assertEquals(
          List.of("the events of topic /left are read; --topic chooses another: /empty, /right"),
          reader.remarks());
    }
    RecordingProblem problem =
        assertThrows(
            RecordingProblem.class, () -> read(bytes, ReadOptions.DEFAULT.withTopic("/middle")));
    assertTrue(problem.getMessage().contains("/empty, /left, /right"), problem.getMessage());
  }

  @Test
  void bagsWithoutEventTopicsAreRejectedWithTheirTopics() {
    byte[] bytes =
        new RosbagFile()
            .topic("/camera", "sensor_msgs/Image")
            .message(0, new byte[100])
            .endChunk()
            .closed();
    RecordingProblem problem = assertThrows(RecordingProblem.class, () -> read(bytes));
    assertTrue(
        problem.getMessage().contains("only /camera (sensor_msgs/Image)"), problem.getMessage());
  }

  @Test
  void edgesAmongEvt3WordsKeepTheirPositionsAmongEvents() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS346, 5, 20_000, 16_000_000, 100);
    Path words = folder.resolve("words.raw");
    RandomSamples samples = new RandomSamples(DAVIS346, 6);
    List<Trigger> triggers = new ArrayList<>();
    try (RecordingWriter writer =
        Recordings.forWriting(words).create(words, WriteOptions.of(DAVIS346)).orElseThrow()) {
      for (int from = 0; from < events.size(); from += 700) {
        triggers.add(samples.edge(events.timeUs(from), 16));
        assertTrue(writer.write(triggers.get(triggers.size() - 1)));
        int to = Math.min(from + 700, events.size());
        writer.write(EventPackets.part(events, from, to));
      }
      writer.finish();
    }
    Path file = Files.write(folder.resolve("edges.bag"), bagOfWords(words));
    ReadOptions options = ReadOptions.DEFAULT.withSamples(true).withPacketEvents(1000);
    StreamRecorder stream = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, options)) {
      reader.drainTo(new StreamGrammar(stream));
      assertEquals(events, stream.events());
      assertEquals(triggers, stream.samples(Trigger.class));
      for (StreamRecorder.Read read : stream.placedSamples()) {
        assertEquals(events.indexAtOrAfter(read.sample().timeUs()), read.eventsBefore());
      }
      assertEquals(triggers.size(), reader.countSamples().triggers());
      long seekUs = events.timeUs(12_345);
      reader.seek(seekUs);
      StreamRecorder part = new StreamRecorder();
      reader.drainTo(part);
      List<Trigger> later = triggers.stream().filter(one -> one.timeUs() >= seekUs).toList();
      assertEquals(later, part.samples(Trigger.class));
    }
  }

  /** A bag whose messages are parts of the words of an EVT3 file. */
  private static byte[] bagOfWords(Path words) throws IOException {
    byte[] all = Files.readAllBytes(words);
    int at = 0;
    while (all[at] == '%') {
      while (all[at++] != '\n') {
        // to the end of the line
      }
    }
    RosbagFile bag = new RosbagFile().topic("/events", PACKET);
    SplittableRandom random = new SplittableRandom(7);
    for (int number = 0; at < all.length; number++) {
      int to = Math.min(all.length, at + 2 * random.nextInt(1, 5_000));
      byte[] part = Arrays.copyOfRange(all, at, to);
      bag.message(0, RosBytes.packet(false, DAVIS346, number, 0, "evt3", false, part));
      at = to;
    }
    return bag.endChunk().closed();
  }

  @Test
  void triggersAndMissingMessagesAndUnknownEncodingsAreCounted() throws IOException {
    byte[] mono = ByteBuffer.allocate(8).putLong(1L << 63 | 3L << 48 | 9L << 32 | 5_999).array();
    byte[] bytes =
        new RosbagFile()
            .topic("/events", PACKET)
            .message(0, RosBytes.packet(false, DAVIS346, 10, 0, "trigger", false, new byte[24]))
            .message(0, RosBytes.packet(false, DAVIS346, 11, 7_000, "mono", true, mono))
            .message(0, RosBytes.packet(false, DAVIS346, 15, 9_001, "mono", true, mono))
            .message(0, RosBytes.packet(false, DAVIS346, 16, 0, "morse", false, new byte[8]))
            .message(0, RosBytes.packet(false, DAVIS346, 17, 0, "trigger", false, new byte[16]))
            .endChunk()
            .closed();
    EventPacket expected = new EventPacket(2);
    expected.append(12, 9, 256, true);
    expected.append(15, 9, 256, true);
    Path file = Files.write(folder.resolve("counted.bag"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(5, reader.violations().count(Violation.OTHER_DATA));
      assertEquals(3, reader.violations().count(Violation.MISSING_MESSAGE));
      assertEquals(1, reader.violations().count(Violation.DAMAGED_PACKET));
    }
    assertEquals(expected, recorder.events());
  }

  @Test
  void chunkAfterADamagedOneIsRead() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS346, 4, 9000, 4_000, 30);
    RosbagFile bag = bag(DAVIS346, events);
    byte[] bytes = bag.closed();
    int second = bag.chunks().get(1);
    EventPacket expected = EventPackets.part(events, 0, 3600);
    expected.append(events, 7200, 9000);
    for (int damagedAt : new int[] {second, second + 3, second + 11}) {
      byte[] damaged = bytes.clone();
      damaged[damagedAt] ^= 0x55;
      assertEquals(expected, read(damaged), "byte " + (damagedAt - second) + " of the chunk");
    }
    // A chunk that says that it continues for 2 GB.
    byte[] lying = bytes.clone();
    int header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(second);
    lying[second + 4 + header + 3] = 0x7f;
    assertEquals(events, read(lying));
  }

  @Test
  void unstatedSensorSizeIsTheSmallestThatFitsTheEvents() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS346, 5, 5000, 4_000, 30);
    byte[] message = RosBytes.array(false, DAVIS346, events);
    int height = 4 + 8 + 4 + "camera".length();
    Arrays.fill(message, height, height + 8, (byte) 0);
    byte[] bytes = new RosbagFile().topic("/events", ARRAY).message(0, message).endChunk().closed();
    assertEquals(events, read(bytes));
    try (RecordingReader reader = Recordings.open(folder.resolve("made.bag"))) {
      assertEquals(DAVIS346, reader.geometry());
      assertTrue(reader.remarks().get(0).contains("346x260"), reader.remarks().toString());
    }
  }

  @Test
  void damagedBagsAreReadOrRejected() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS346, 6, 150, 4_000, 30);
    List<byte[]> wholes =
        List.of(
            bag(DAVIS346, events).closed(),
            BagResources.bytes("array-lz4.bag"),
            BagResources.bytes("array-bz2.bag"),
            BagResources.bytes("libcaer_cmp.bag"));
    SplittableRandom random = new SplittableRandom(9);
    Path file = folder.resolve("fuzz.bag");
    int read = 0;
    for (int i = 0; i < 800; i++) {
      byte[] bytes = wholes.get(i % wholes.size()).clone();
      for (int flips = 1 + random.nextInt(6); flips > 0; flips--) {
        // Not in the filling of the first record, which is as long as all the others.
        int at = random.nextInt(bytes.length - 4000);
        bytes[at < 110 ? at : at + 4000] ^= (byte) (1 << random.nextInt(8));
      }
      if (random.nextInt(3) == 0) {
        bytes = Arrays.copyOf(bytes, 4100 + random.nextInt(bytes.length - 4100));
      }
      ReplacedFile.write(file, bytes);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          new RosbagFormat().open(file, ReadOptions.DEFAULT.withPacketEvents(40))) {
        reader.drainTo(new StreamGrammar(recorder));
        reader.seek(5_000);
        read += recorder.events().isEmpty() ? 0 : 1;
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
    assertTrue(read > 400, read + " of the bags gave events");
  }

  @Test
  void fileOfAnotherVersionIsNotRecognised() throws IOException {
    byte[] bytes = "#ROSBAG V1.2\n".getBytes(StandardCharsets.US_ASCII);
    Path file = Files.write(folder.resolve("old.bag"), bytes);
    assertThrows(
        RecordingProblem.class, () -> new RosbagFormat().open(file, ReadOptions.DEFAULT).close());
  }
}
