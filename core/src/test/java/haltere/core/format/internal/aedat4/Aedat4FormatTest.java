package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.LittleEndian;
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
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** AEDAT-4.0 keeps the contract of all formats. */
class Aedat4FormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new Aedat4Format();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        DAVIS346,
        new SensorGeometry(1, 1),
        new SensorGeometry(1280, 720),
        new SensorGeometry(32768, 32768));
  }

  @Override
  protected long earliestUs() {
    return Long.MIN_VALUE + 1;
  }

  @Override
  protected long latestUs() {
    return Long.MAX_VALUE;
  }

  @Override
  protected boolean endsInEvents() {
    return false;
  }

  private static int headerEnd(byte[] file) {
    return Aedat4Header.MAGIC_BYTES
        + 4
        + ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).getInt(Aedat4Header.MAGIC_BYTES);
  }

  private static byte[] withInt(byte[] file, int at, int value) {
    byte[] copy = file.clone();
    ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN).putInt(at, value);
    return copy;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    int packet = headerEnd(file);
    List<byte[]> lies = new ArrayList<>();
    for (int lie : new int[] {0, 1, -1, 7, 100, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 30}) {
      lies.add(withInt(file, Aedat4Header.MAGIC_BYTES, lie));
      lies.add(withInt(file, Aedat4Header.MAGIC_BYTES + 4, lie));
      lies.add(withInt(file, Aedat4Header.TABLE_POSITION_OFFSET, lie));
      lies.add(withInt(file, Aedat4Header.TABLE_POSITION_OFFSET + 4, lie));
      lies.add(withInt(file, packet, lie));
      lies.add(withInt(file, packet + 4, lie));
      for (int at = packet + 8; at < packet + 60; at++) {
        lies.add(withInt(file, at, lie));
      }
    }
    String text = new String(file, StandardCharsets.ISO_8859_1);
    for (String size : List.of("000", "999", "-12", "abc", "1e9", "<x>", "&a;")) {
      lies.add(text.replace("346", size).getBytes(StandardCharsets.ISO_8859_1));
    }
    return lies;
  }

  private static EventPacket events(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT)) {
      reader.drainTo(recorder);
    }
    return recorder.events();
  }

  @ParameterizedTest
  @EnumSource(Aedat4Compression.class)
  void everyCompressionIsReadBack(Aedat4Compression compression) throws IOException {
    Path file = folder.resolve(compression + ".aedat4");
    EventPacket written = EventPackets.uniform(DAVIS346, 3, 50_000, 1_718_925_184_590_631L, 9);
    try (RecordingWriter writer =
        Aedat4Writer.create(file, WriteOptions.of(DAVIS346), compression)) {
      for (EventPacket part : EventPackets.cut(written, 5)) {
        writer.write(part);
      }
      writer.finish();
    }
    assertEquals(written, events(file));
    if (compression != Aedat4Compression.NONE) {
      assertTrue(Files.size(file) < 13L * written.size(), Files.size(file) + " bytes");
    }
  }

  @Test
  void recordingsInPlaceAreReadableUpToTheLastPacket() throws IOException {
    Path file = folder.resolve("live.aedat4");
    EventPacket written = EventPackets.uniform(DAVIS346, 4, 40_000, 0, 9);
    try (Aedat4Writer writer =
        Aedat4Writer.createInPlace(file, WriteOptions.of(DAVIS346), Aedat4Compression.LZ4)) {
      writer.write(EventPackets.part(written, 0, 20_000));
      assertEquals(EventPackets.part(written, 0, 16_384), events(file));
      writer.writeThrough();
      assertEquals(EventPackets.part(written, 0, 20_000), events(file));
      writer.write(EventPackets.part(written, 20_000, 40_000));
    }
    assertEquals(EventPackets.part(written, 0, 36_384), events(file));
  }

  @Test
  void packetsThatClaimTwoGigabytesNeedLittleMemory() throws IOException {
    Path file = folder.resolve("sparse.aedat4");
    write(file, DAVIS346, EventPackets.uniform(DAVIS346, 4, 4, 0, 9));
    byte[] bytes = Files.readAllBytes(file);
    byte[] open =
        withInt(
            withInt(bytes, Aedat4Header.TABLE_POSITION_OFFSET, -1),
            Aedat4Header.TABLE_POSITION_OFFSET + 4,
            -1);
    int packet = headerEnd(open);
    byte[] start = Arrays.copyOf(open, packet + 8 + 32);
    int size = Integer.MAX_VALUE - 64;
    ByteBuffer lie = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
    lie.putInt(packet + 4, size);
    lie.position(packet + 8);
    lie.putInt(size - 4).putInt(16).put("EVTS".getBytes(StandardCharsets.ISO_8859_1));
    lie.putShort((short) 0).putShort((short) 6).putShort((short) 8).putShort((short) 4);
    lie.putInt(6).putInt(4).putInt(Integer.MAX_VALUE);
    try (java.io.RandomAccessFile sparse = new java.io.RandomAccessFile(file.toFile(), "rw")) {
      sparse.setLength(0);
      sparse.write(start);
      sparse.setLength(packet + 8L + size);
    }
    long[] read = new long[1];
    try (RecordingReader reader = Recordings.open(file)) {
      while (read[0] < 3_000_000
          && reader.next(
              new haltere.core.stream.StreamHandler() {
                @Override
                public void packet(EventPacket packet) {
                  read[0] += packet.size();
                }

                @Override
                public void notified(haltere.core.stream.StreamNotification notification) {}
              })) {
        // As far as it goes.
      }
    }
    assertTrue(read[0] >= 3_000_000, read[0] + " events");
  }

  @Test
  void damagedPacketIsSkippedAndLaterOnesAreFound() throws IOException {
    EventPacket written = EventPackets.uniform(DAVIS346, 6, 3 * 8192, 0, 9);
    for (Aedat4Compression compression :
        new Aedat4Compression[] {Aedat4Compression.NONE, Aedat4Compression.LZ4}) {
      Path file = folder.resolve("damaged-" + compression + ".aedat4");
      try (RecordingWriter writer =
          Aedat4Writer.create(file, WriteOptions.of(DAVIS346), compression)) {
        writer.write(written);
        writer.finish();
      }
      byte[] bytes = Files.readAllBytes(file);
      int first = headerEnd(bytes);
      int second =
          first + 8 + ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(first + 4);
      EventPacket expected = EventPackets.part(written, 0, 8192);
      expected.append(written, 2 * 8192, 3 * 8192);
      for (byte[] damaged :
          List.of(
              withInt(bytes, second, 0x7777_7777),
              withInt(bytes, second + 4, 0x7777_7777),
              withInt(bytes, second + 4, -5),
              withInt(bytes, second + 4, 25),
              withInt(bytes, second + 8, 0x7777_7777))) {
        ReplacedFile.write(file, damaged);
        StreamRecorder recorder = new StreamRecorder();
        try (RecordingReader reader = Recordings.open(file)) {
          reader.drainTo(recorder);
          long lying = reader.violations().count(Violation.IMPOSSIBLE_LENGTH);
          long damage = reader.violations().count(Violation.DAMAGED_PACKET);
          long other = reader.violations().count(Violation.OTHER_DATA);
          assertEquals(damaged[second] == 0x77 ? 1 : 0, other, "a stream of its own");
          assertTrue(lying + damage + other >= 1, reader.violations().describe().toString());
          assertEquals(0, reader.violations().count(Violation.CUT_OFF));
        }
        assertEquals(expected, recorder.events());
      }
    }
  }

  @Test
  void metadataAreReadBackAsPlainText() throws IOException {
    Path file = folder.resolve("metadata.aedat4");
    WriteOptions options =
        new WriteOptions(
            DAVIS346,
            false,
            Optional.empty(),
            Map.of("source", "<\"&>\0\r\n ü \uD83D\uDE00 \uD800", "a\"b<", "&lt;"));
    try (RecordingWriter writer = new Aedat4Format().create(file, options).orElseThrow()) {
      writer.finish();
    }
    Aedat4Stream stream = Aedat4Format.streams(file).get(0);
    assertEquals(Optional.of("<\"&>??  ü \uD83D\uDE00 ?"), stream.source());
    assertEquals("EVTS", stream.type());
    assertEquals(346, stream.width());
  }

  @Test
  void eventsOutsideTheSensorAreSkippedAndReported() throws IOException {
    Path file = folder.resolve("outside.aedat4");
    EventPacket written = new EventPacket(4);
    written.append(0, 345, 259, true);
    written.append(1, 346, 0, true);
    written.append(2, 0, 260, true);
    written.append(3, 0, 0, false);
    try (RecordingWriter writer =
        new Aedat4Format().create(file, WriteOptions.of(DAVIS346)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(List.of("2 events outside of 346x260 were left out"), writer.losses());
    }
    EventPacket expected = EventPackets.part(written, 0, 1);
    expected.append(written, 3, 4);
    assertEquals(expected, events(file));
  }

  /** As jAER writes: rows from the bottom, the table's position -2 while the file is open. */
  private static byte[] withHeader(byte[] file, String infoNode, long tablePosition) {
    byte[] header = Aedat4Header.write(Aedat4Compression.NONE, infoNode);
    LittleEndian.putLong(header, Aedat4Header.TABLE_POSITION_OFFSET, tablePosition);
    int from = headerEnd(file);
    int to = (int) LittleEndian.getLong(file, Aedat4Header.TABLE_POSITION_OFFSET);
    return ByteBuffer.allocate(header.length + to - from)
        .put(header)
        .put(file, from, to - from)
        .array();
  }

  @Test
  void jaerFileHasRowsFromTheBottom() throws IOException {
    Path file = folder.resolve("jaer.aedat4");
    EventPacket written = EventPackets.uniform(DAVIS346, 8, 900, 0, 9);
    write(file, DAVIS346, written);
    String info =
        InfoNode.of("LZ4", DAVIS346, "DAVIS346", Map.of(), Set.of()).replace(">haltere<", ">jAER<");
    Files.write(file, withHeader(Files.readAllBytes(file), info, -2));
    EventPacket expected = EventPackets.copy(written);
    for (int i = 0; i < expected.size(); i++) {
      int y = 259 - expected.y(i);
      expected.setAddress(
          i, haltere.core.event.EventAddress.pack(expected.x(i), y, expected.isOn(i)));
    }
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(346, 260, Origin.BOTTOM), reader.geometry());
      assertEquals(List.of(), reader.violations().describe());
    }
    assertEquals(expected, events(file));
  }

  @Test
  void missingDescriptionIsReplacedByTheContentOfPackets() throws IOException {
    Path file = folder.resolve("undescribed.aedat4");
    EventPacket written = new EventPacket(2);
    written.append(5, 0, 250, true);
    written.append(6, 300, 259, false);
    write(file, DAVIS346, written);
    byte[] bytes = Files.readAllBytes(file);
    for (String info : List.of("<dv><node name=", "", "<!DOCTYPE dv [<!ENTITY a \"b\">]><dv>&a;")) {
      ReplacedFile.write(file, withHeader(bytes, info, -1));
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(new SensorGeometry(301, 10, Origin.TOP), reader.geometry());
        assertEquals(2, reader.remarks().size(), reader.remarks().toString());
      }
      assertEquals(2, events(file).size());
    }
  }

  @Test
  void externalEntitiesAreNotRead() throws IOException {
    Path secret = Files.writeString(folder.resolve("secret.txt"), "346");
    Path file = folder.resolve("entity.aedat4");
    write(file, DAVIS346, EventPackets.uniform(DAVIS346, 8, 9, 0, 9));
    String info =
        "<!DOCTYPE dv [<!ENTITY a SYSTEM \""
            + secret.toUri()
            + "\">]>"
            + InfoNode.of("LZ4", new SensorGeometry(7777, 260), "x", Map.of(), Set.of())
                .replace("7777", "&a;");
    Files.write(file, withHeader(Files.readAllBytes(file), info, -1));
    assertTrue(Aedat4Format.streams(file).stream().noneMatch(stream -> stream.width() == 346));
  }

  @Test
  void firstOfSeveralEventStreamsIsRead() throws IOException {
    EventPacket first = EventPackets.uniform(DAVIS346, 8, 900, 0, 9);
    EventPacket second = EventPackets.uniform(DAVIS346, 9, 800, 0, 9);
    Path file = folder.resolve("one.aedat4");
    write(file, DAVIS346, first);
    Path other = folder.resolve("other.aedat4");
    write(other, DAVIS346, second);
    String one = InfoNode.of("LZ4", DAVIS346, "x", Map.of(), Set.of());
    int node = one.indexOf("        <node name=\"0\"");
    int end = one.indexOf("    </node>\n</dv>");
    String two = one.substring(0, end) + one.substring(node, end).replace("\"0\"", "\"4\"");
    byte[] bytes = withHeader(Files.readAllBytes(file), two + one.substring(end), -1);
    byte[] more = withHeader(Files.readAllBytes(other), "<dv/>", -1);
    int packet = headerEnd(more);
    LittleEndian.putInt(more, packet, 4);
    byte[] both = Arrays.copyOf(bytes, bytes.length + more.length - packet);
    System.arraycopy(more, packet, both, bytes.length, more.length - packet);
    Files.write(file, both);

    assertEquals(first, events(file));
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader =
        new Aedat4Format().open(file, ReadOptions.DEFAULT, java.util.OptionalInt.of(4))) {
      reader.drainTo(recorder);
      assertTrue(reader.remarks().get(0).contains("2 streams"), reader.remarks().toString());
    }
    assertEquals(second, recorder.events());
    org.junit.jupiter.api.Assertions.assertThrows(
        haltere.core.format.RecordingProblem.class,
        () -> new Aedat4Format().open(file, ReadOptions.DEFAULT, java.util.OptionalInt.of(1)));
    StreamRecorder named = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withTopic("4"))) {
      reader.drainTo(named);
      assertTrue(reader.remarks().get(0).contains("--topic chooses another: 0"));
    }
    assertEquals(second, named.events());
    org.junit.jupiter.api.Assertions.assertThrows(
        haltere.core.format.RecordingProblem.class,
        () -> Recordings.open(file, ReadOptions.DEFAULT.withTopic("left")).close());
  }

  @Test
  void recordingOfFramesOnlyHasNoEvents() throws IOException {
    Path file = haltere.testing.Recorded.file("gray16-frame.aedat4");
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(2, 2, Origin.TOP), reader.geometry());
      assertEquals(List.of("it holds no stream of events"), reader.remarks());
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertEquals(0, recorder.events().size());
      assertEquals(1, reader.violations().count(Violation.OTHER_DATA));
    }
  }
}
