package haltere.core.format.internal.npz;

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
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** NumPy's files keep the contract of all formats, whatever the types of their arrays. */
class NpzFormatTest extends RecordingFormatContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260);

  @Override
  protected RecordingFormat format() {
    return new NpzFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        SENSOR,
        new SensorGeometry(1280, 720, Origin.TOP),
        new SensorGeometry(1, 1),
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

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    String text = new String(file, StandardCharsets.ISO_8859_1);
    List<byte[]> lies = new ArrayList<>();
    for (String shape : List.of("(500, )", "(599,)", "(0,)  ", "(5,9,)", "(-9,) ", "(9e9,)")) {
      lies.add(text.replace("(500,)", shape).getBytes(StandardCharsets.ISO_8859_1));
    }
    for (String shape : List.of("(999999999999999999,)", "(99999999999999999999,)")) {
      lies.add(
          text.replace("(500,), }               ", shape + ", }")
              .getBytes(StandardCharsets.ISO_8859_1));
    }
    for (String type : List.of("<i9", "<u8", "|V2", "<U9", "<f8", "|O8")) {
      lies.add(text.replace("<u2", type).getBytes(StandardCharsets.ISO_8859_1));
    }
    return lies;
  }

  private static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(recorder);
    return recorder;
  }

  private static byte[] array(String type, String shape, ByteBuffer data) {
    String text =
        "{'descr': " + type + ", 'fortran_order': False, 'shape': (" + shape + "), }    \n";
    ByteBuffer bytes =
        ByteBuffer.allocate(10 + text.length() + data.limit()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put(new byte[] {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0});
    bytes.putShort((short) text.length()).put(text.getBytes(StandardCharsets.US_ASCII));
    return bytes.put(data).array();
  }

  private static byte[] stored(Map<String, byte[]> arrays) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.setMethod(ZipOutputStream.STORED);
      for (Map.Entry<String, byte[]> array : arrays.entrySet()) {
        CRC32 crc = new CRC32();
        crc.update(array.getValue());
        ZipEntry entry = new ZipEntry(array.getKey() + ".npy");
        entry.setSize(array.getValue().length);
        entry.setCrc(crc.getValue());
        zip.putNextEntry(entry);
        zip.write(array.getValue());
        zip.closeEntry();
      }
    }
    return bytes.toByteArray();
  }

  private static byte[] zipped(Map<String, byte[]> arrays) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (Map.Entry<String, byte[]> array : arrays.entrySet()) {
        zip.putNextEntry(new ZipEntry(array.getKey() + ".npy"));
        zip.write(array.getValue());
        zip.closeEntry();
      }
    }
    return bytes.toByteArray();
  }

  private static ByteBuffer buffer(int bytes, ByteOrder order) {
    return ByteBuffer.allocate(bytes).order(order);
  }

  /** The events' columns as programs of the field save them. */
  private static Map<String, byte[]> columns(EventPacket events, boolean seconds) {
    int size = events.size();
    ByteBuffer t = buffer(8 * size, ByteOrder.BIG_ENDIAN);
    ByteBuffer x = buffer(8 * size, ByteOrder.LITTLE_ENDIAN);
    ByteBuffer y = buffer(4 * size, ByteOrder.LITTLE_ENDIAN);
    ByteBuffer p = buffer(size, ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < size; i++) {
      if (seconds) {
        t.putDouble(events.timeUs(i) / 1e6);
      } else {
        t.putLong(events.timeUs(i));
      }
      x.putLong(events.x(i));
      y.putFloat(259 - events.y(i));
      p.put((byte) (events.isOn(i) ? 1 : -1));
    }
    Map<String, byte[]> arrays = new LinkedHashMap<>();
    arrays.put("label", array("'<U3'", "", buffer(12, ByteOrder.LITTLE_ENDIAN)));
    arrays.put("polarity", array("'|i1'", size + ",", p.flip()));
    arrays.put("events/x", array("'<i8'", size + ",", x.flip()));
    arrays.put("y", array("'<f4'", size + ",", y.flip()));
    arrays.put("timestamps", array(seconds ? "'>f8'" : "'>i8'", size + ",", t.flip()));
    return arrays;
  }

  /** A table whose columns hold, in the order of the letters, times, pixels and signs. */
  private static byte[] table(EventPacket events, String order, boolean isByColumns, String head) {
    ByteBuffer numbers = buffer(32 * events.size(), ByteOrder.LITTLE_ENDIAN);
    for (int k = 0; k < 4 * events.size(); k++) {
      int i = isByColumns ? k % events.size() : k / 4;
      char column = order.charAt(isByColumns ? k / events.size() : k % 4);
      numbers.putDouble(
          switch (column) {
            case 't' -> events.timeUs(i) / 1e6;
            case 'x' -> events.x(i);
            case 'y' -> 259 - events.y(i);
            default -> events.isOn(i) ? 1 : -1;
          });
    }
    byte[] bytes = array("'<f8'", head, numbers.flip());
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    return isByColumns
        ? text.replace("r': False, ", "r': True,  ").getBytes(StandardCharsets.ISO_8859_1)
        : bytes;
  }

  @ParameterizedTest
  @ValueSource(strings = {"txyp", "xytp", "xypt"})
  void tableWithoutNamesIsReadInAnyOrderAndLayout(String order) throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 5, 9_000, 1_000_000, 40);
    int rows = events.size();
    Map<String, byte[]> tables =
        Map.of(
            "upright.npy", table(events, order, false, rows + ", 4"),
            "by-columns.npy", table(events, order, true, rows + ", 4"),
            "packed.npz", zipped(Map.of("events", table(events, order, false, rows + ", 4"))),
            "packed-by-columns.npz", zipped(Map.of("e", table(events, order, true, rows + ", 4"))));
    for (Map.Entry<String, byte[]> table : tables.entrySet()) {
      Path file = Files.write(folder.resolve(table.getKey()), table.getValue());
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(events, read(reader).events(), table.getKey());
        assertTrue(reader.remarks().toString().contains("time"), reader.remarks().toString());
        assertEquals(List.of(), reader.violations().describe());
        reader.seek(events.timeUs(5_000));
        int first = events.indexAtOrAfter(events.timeUs(5_000));
        assertEquals(EventPackets.part(events, first, rows), read(reader).events());
      }
    }
  }

  @Test
  void tableThatIsCutOffHasNoInventedEvents() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 5, 9_000, 1_000_000, 40);
    for (boolean isByColumns : new boolean[] {false, true}) {
      byte[] whole = table(events, "txyp", isByColumns, "9000, 4");
      Path file = folder.resolve("cut.npy");
      Files.write(file, Arrays.copyOf(whole, whole.length - 8 * 100));
      try (RecordingReader reader = Recordings.open(file)) {
        EventPacket got = read(reader).events();
        assertEquals(isByColumns ? 8_900 : 8_975, got.size());
        assertEquals(EventPackets.part(events, 0, got.size()), got);
        assertTrue(reader.violations().count(Violation.IMPOSSIBLE_LENGTH) > 0);
      }
      Files.write(file, table(events, "txyp", isByColumns, "900000000000000000, 4"));
      if (isByColumns) {
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
      } else {
        try (RecordingReader reader = Recordings.open(file)) {
          assertEquals(events, read(reader).events());
        }
      }
    }
  }

  @Test
  void columnsOfOneColumnEachAreLists() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 6, 500, 1_000_000, 40);
    Map<String, byte[]> arrays = columns(events, false);
    arrays.replaceAll(
        (name, bytes) ->
            new String(bytes, StandardCharsets.ISO_8859_1)
                .replace("(500,), }  ", "(500, 1), }")
                .getBytes(StandardCharsets.ISO_8859_1));
    Path file = Files.write(folder.resolve("upright.npz"), zipped(arrays));
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(events, read(reader).events());
    }
  }

  @Test
  void oneOfTwoTablesIsReadAndTheOtherIsNamed() throws IOException {
    EventPacket left = EventPackets.uniform(SENSOR, 7, 300, 1_000_000, 40);
    EventPacket right = EventPackets.uniform(SENSOR, 8, 200, 1_000_000, 40);
    Map<String, byte[]> tables = new LinkedHashMap<>();
    tables.put("left", table(left, "txyp", false, "300, 4"));
    tables.put("right", table(right, "xytp", false, "200, 4"));
    Path file = Files.write(folder.resolve("cameras.npz"), zipped(tables));
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(left, read(reader).events());
      assertTrue(reader.remarks().toString().contains("--topic chooses another: right"));
    }
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withTopic("right").withSensor(SENSOR))) {
      assertEquals(right.size(), read(reader).events().size());
      assertTrue(reader.remarks().toString().contains("--topic chooses another: left"));
    }
    RecordingProblem missing =
        assertThrows(
            RecordingProblem.class,
            () -> Recordings.open(file, ReadOptions.DEFAULT.withTopic("top")).close());
    assertTrue(missing.getMessage().endsWith("; there are left, right"), missing.getMessage());
  }

  @Test
  void tableOfOtherNumbersIsNoRecording() throws IOException {
    ByteBuffer numbers = buffer(32 * 100, ByteOrder.LITTLE_ENDIAN);
    SplittableRandom random = new SplittableRandom(1);
    while (numbers.hasRemaining()) {
      numbers.putDouble(random.nextDouble());
    }
    Path file = folder.resolve("other.npy");
    Files.write(file, array("'<f8'", "100, 4", numbers.flip()));
    assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
  }

  @Test
  void compressedArraysOfAnyTypeAreReadAndSeekable() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 1, 30_000, 1_718_925_184_590_631L, 40);
    for (boolean seconds : new boolean[] {true, false}) {
      Path file = folder.resolve("packed-" + seconds + ".npz");
      Files.write(file, zipped(columns(events, seconds)));
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(new SensorGeometry(346, 260, Origin.TOP), reader.geometry());
        assertEquals("deflate", reader.compression().orElseThrow());
        assertEquals(events, read(reader).events());
        assertEquals(List.of(), reader.violations().describe());
        for (int from : new int[] {25_000, 10, 29_999}) {
          reader.seek(events.timeUs(from));
          int first = events.indexAtOrAfter(events.timeUs(from));
          assertEquals(EventPackets.part(events, first, events.size()), read(reader).events());
        }
      }
    }
  }

  @Test
  void structuredArrayIsReadAloneAndInAZipFile() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 2, 10_000, 5, 40);
    ByteBuffer data = buffer(13 * events.size(), ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < events.size(); i++) {
      data.putShort((short) events.x(i)).putShort((short) (259 - events.y(i)));
      data.putLong(events.timeUs(i) * 1000).put((byte) (events.isOn(i) ? 1 : 0));
    }
    byte[] array =
        array(
            "[('x', '<i2'), ('y', '<i2'), ('t_ns', '<i8'), ('p', '|b1')]",
            events.size() + ",",
            data.flip());
    Map<String, byte[]> withFrames = new LinkedHashMap<>();
    withFrames.put("t", array("'<i8'", "2,", ByteBuffer.allocate(16)));
    withFrames.put("events", array);
    for (byte[] bytes : List.of(array, zipped(Map.of("arr_0", array)), zipped(withFrames))) {
      Path file = ReplacedFile.write(folder.resolve("structured"), bytes);
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(events, read(reader).events());
      }
    }
  }

  @Test
  void writtenFilesArePlainZipFilesWithSizeAndOrigin() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 3, 20_000, 5, 40);
    for (Origin origin : Origin.values()) {
      SensorGeometry sensor = new SensorGeometry(346, 260, origin);
      Path file = folder.resolve(origin + ".npz");
      write(file, sensor, events);
      try (ZipFile zip = new ZipFile(file.toFile())) {
        assertEquals(
            List.of("width.npy", "height.npy", "rows_up.npy", "t.npy", "x.npy", "y.npy", "p.npy"),
            zip.stream().map(ZipEntry::getName).toList());
        for (ZipEntry entry : zip.stream().toList()) {
          byte[] bytes = zip.getInputStream(entry).readAllBytes();
          assertEquals(entry.getSize(), bytes.length);
        }
      }
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(sensor, reader.geometry());
        assertEquals(List.of(), reader.remarks());
        assertEquals(events, read(reader).events());
      }
    }
  }

  @Test
  void filesWithoutADirectoryAreReadAsFarAsPossible() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 4, 1000, 5, 40);
    Path file = folder.resolve("lost.npz");
    write(file, SENSOR, events);
    byte[] bytes = Files.readAllBytes(file);
    Files.write(file, Arrays.copyOf(bytes, bytes.length - 900));
    try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
      EventPacket got = read(reader).events();
      assertTrue(got.size() > 500 && got.size() < 1000, got.toString());
      assertEquals(EventPackets.part(events, 0, got.size()), got);
      assertEquals(1, reader.violations().count(Violation.CUT_OFF));
      assertEquals(1, reader.violations().count(Violation.IMPOSSIBLE_LENGTH));
    }
  }

  @Test
  void truncatedFilesOfOtherProgramsYieldNoInventedEvent() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 6, 100, 5_000_000, 40);
    Map<String, byte[]> arrays = columns(events, true);
    byte[] whole = stored(arrays);
    Path file = folder.resolve("cut.npz");
    for (int length = whole.length - 1; length > 0; length--) {
      ReplacedFile.write(file, Arrays.copyOf(whole, length));
      try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
        EventPacket got = read(reader).events();
        assertEquals(EventPackets.part(events, 0, got.size()), got, "cut to " + length + " bytes");
      } catch (RecordingProblem problem) {
        assertEquals(1, problem.getMessage().lines().count());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"1,%d", "%d,1"})
  void arraysOfOneRowOrColumnAreLists(String shape) throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 3, 50, 5, 40);
    Map<String, byte[]> arrays = columns(events, false);
    ByteBuffer times = buffer(8 * events.size(), ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < events.size(); i++) {
      times.putLong(events.timeUs(i));
    }
    arrays.put("t", array("'<i8'", shape.formatted(events.size()), times.flip()));
    Path file = Files.write(folder.resolve("list.npz"), zipped(arrays));
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
      assertEquals(events, read(reader).events());
    }
  }

  @Test
  void polaritiesOfWhichNoneIsOffAreRejected() throws IOException {
    Map<String, byte[]> arrays = columns(EventPackets.uniform(SENSOR, 7, 4, 5, 40), false);
    arrays.keySet().removeIf(name -> name.startsWith("p"));
    arrays.put("p", array("'|u1'", "4,", ByteBuffer.wrap(new byte[] {1, 2, 2, 1})));
    Path file = Files.write(folder.resolve("matlab.npz"), zipped(arrays));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("polarities are 1 to 2"), refused.getMessage());
  }

  @Test
  void eventsWithoutPolaritiesAreToldToBeOn() throws IOException {
    Map<String, byte[]> arrays = columns(EventPackets.uniform(SENSOR, 7, 10, 5, 40), false);
    arrays.keySet().removeIf(name -> name.startsWith("p"));
    Path file = Files.write(folder.resolve("unsigned.npz"), zipped(arrays));
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
      assertEquals(10, read(reader).events().size());
      assertTrue(reader.remarks().toString().contains("as ON"), reader.remarks().toString());
    }
  }

  @Test
  void nonNumericPolaritiesAreRejected() throws IOException {
    Map<String, byte[]> arrays = columns(EventPackets.uniform(SENSOR, 7, 10, 5, 40), false);
    arrays.put("polarity", array("'<U3'", "10,", buffer(120, ByteOrder.LITTLE_ENDIAN)));
    Path file = Files.write(folder.resolve("words.npz"), zipped(arrays));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("polarities"), refused.getMessage());
  }

  @Test
  void rowsWithoutNumbersAreSkippedAndCounted() throws IOException {
    double[] timesUs = {5, Double.NaN, 7, Double.POSITIVE_INFINITY, 1e300, 9};
    float[] ups = {1, 1, 1, 1, 1, Float.NaN};
    ByteBuffer t = buffer(8 * timesUs.length, ByteOrder.LITTLE_ENDIAN);
    ByteBuffer y = buffer(4 * ups.length, ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < timesUs.length; i++) {
      t.putDouble(timesUs[i]);
      y.putFloat(ups[i]);
    }
    Map<String, byte[]> arrays = new LinkedHashMap<>();
    arrays.put("t", array("'<f8'", "6,", t.flip()));
    arrays.put("x", array("'|u1'", "6,", ByteBuffer.allocate(6)));
    arrays.put("y", array("'<f4'", "6,", y.flip()));
    EventPacket expected = new EventPacket(2);
    expected.append(5, 0, 258, true);
    expected.append(7, 0, 258, true);
    Path file = Files.write(folder.resolve("holes.npz"), zipped(arrays));
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
      assertEquals(expected, read(reader).events());
      assertEquals(4, reader.violations().count(Violation.UNKNOWN_WORD));
    }
  }

  @Test
  void arraysOfDifferentLengthsAreReportedAndReadToTheShortest() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 5, 1000, 5, 40);
    Map<String, byte[]> arrays = columns(events, false);
    Map<String, byte[]> shorter = columns(EventPackets.part(events, 0, 700), false);
    arrays.put("y", shorter.get("y"));
    Path file = Files.write(folder.resolve("short.npz"), zipped(arrays));
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
      assertEquals(EventPackets.part(events, 0, 700), read(reader).events());
      assertEquals(1, reader.violations().count(Violation.IMPOSSIBLE_LENGTH));
    }
  }

  @Test
  void arraysWithoutEventsAreRejectedByName() throws IOException {
    byte[] weights = array("'<f4'", "2,2", buffer(16, ByteOrder.LITTLE_ENDIAN));
    Path file = Files.write(folder.resolve("weights.npz"), zipped(Map.of("weights", weights)));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("[weights]"), refused.getMessage());
  }
}
