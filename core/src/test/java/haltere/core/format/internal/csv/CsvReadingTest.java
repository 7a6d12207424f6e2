package haltere.core.format.internal.csv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.testing.RecordingFormatContract;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Text keeps the contract of all formats, with its columns in any order. */
class CsvReadingTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new CsvFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        DAVIS346,
        new SensorGeometry(1, 1, Origin.TOP),
        new SensorGeometry(1280, 720, Origin.TOP),
        new SensorGeometry(32768, 32768, Origin.TOP));
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
    // The last line feed may be missing.
    return false;
  }

  @Override
  protected ReadOptions options(SensorGeometry sensor) {
    return ReadOptions.DEFAULT.withSensor(sensor);
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    String text = new String(file, StandardCharsets.US_ASCII);
    List<byte[]> lies = new ArrayList<>();
    for (String line :
        List.of(
            "99999999999999999999,1,1,1",
            "1e999999999,1,1,1",
            "1e-999999999,1,1,1",
            "5,-1,1,1",
            "5,4294967297,1,1",
            "5,1,99999999999999999999999,1",
            "NaN,inf,1,1",
            ",,,",
            "1,2",
            "5,1" + " ".repeat(300_000) + "1,1",
            "1".repeat(300_000),
            "1,".repeat(300_000))) {
      lies.add((text + line + "\n" + line).getBytes(StandardCharsets.US_ASCII));
      lies.add(text.replaceFirst("\n", "\n" + line + "\n").getBytes(StandardCharsets.US_ASCII));
    }
    lies.add("#\n".repeat(500_000).getBytes(StandardCharsets.US_ASCII));
    lies.add((text + "\n".repeat(500_000)).getBytes(StandardCharsets.US_ASCII));
    return lies;
  }

  private EventPacket events(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("text"), text, StandardCharsets.ISO_8859_1);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(10, 10)))) {
      reader.drainTo(recorder);
    }
    return recorder.events();
  }

  private static EventPacket expected() {
    EventPacket expected = new EventPacket(0);
    expected.append(1_500_000, 3, 7, true);
    expected.append(1_500_001, 4, 0, false);
    expected.append(2_000_000, 9, 9, true);
    return expected;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "t_us,x,y,on\n1500000,3,2,1\n1500001,4,9,0\n2000000,9,0,1\n",
        "t_us,x,y,on\r\n1500000,3,2,1\r\n1500001,4,9,0\r\n2000000,9,0,1\r\n",
        "\u00ef\u00bb\u00bft_us,x,y,on\n1500000,3,2,1\n1500001,4,9,0\n2000000,9,0,1",
        "x,y,polarity,timestamp\n3,2,1,1500000\n4,9,-1,1500001\n9,0,1,2000000\n",
        "# x y p time_s\n3 2 1 1.5\n4 9 0 1.500001\n9 0 1 2\n",
        "t,x,y,p\n1.5,3,2,1\n1.500001,4,9,0\n2.0,9,0,1\n",
        "Time [ns];Col;Row;Sign\n1500000000;3;2;1\n1500001000;4;9;-1\n2000000000;9;0;1\n",
        "t_ms\tx\ty\tp\n1500\t3\t2\ttrue\n1500.001\t4\t9\tFalse\n2e3\t9\t0\tTrue\n",
        "t;x;y;p\n1,5;3;2;1\n1,500001;4;9;0\n2,0;9;0;1\n",
        "1,500000;3;2;1\n1,500001;4;9;0\n2,000000;9;0;1\n",
        "p;t_us;x;y\nON;1500000;3;2\nOFF;1500001;4;9\nON;2000000;9;0\n",
        "pol\ttime [us]\tx\ty\n1\t1500000\t3\t2\n0\t1500001\t4\t9\n1\t2000000\t9\t0\n",
        "t,a,x,y,p,label\n1500000,0.1,3,2,1,fly\n1500001,x,4,9,0,fly\n2000000,7,9,0,1,\n",
        "\"t_us\",\"x\",\"y\",\"p\"\n\"1500000\",\"3\",\"2\",\"1\"\n\"1500001\",4,9,\"0\"\n2000000,9,0,1\n",
        "\"t_us\" \"x\" \"y\" \"p\"\n\"1\" 1500000 3 2 1\n\"2\" 1500001 4 9 0\n\"3\" 2000000 9 0 1\n",
        "t [\u00b5s],x,y,p\n1500000,3,2,+\n1500001,4,9,-\n2000000,9,0,+\n",
        "t (\u00c2\u00b5s),x,y,p\n1500000,3,2,pos\n1500001,4,9,neg\n2000000,9,0,pos\n",
        "time (\u00ce\u00bcs),x,y,p\n1500000,3,2,CD_ON\n1500001,4,9,CD_OFF\n2000000,9,0,CD_ON\n",
        "timestamp usec,x_addr,y_addr,is_on\n1500000,3,2,1\n1500001,4,9,0\n2000000,9,0,1\n",
        "t,x,y,is_increase\n1500000,3,2,1\n1500001,4,9,0\n2000000,9,0,1\n",
        "# columns: t x y p\n1500000 3 2 1\n1500001 4 9 0\n2000000 9 0 1\n",
        "# t, x, y of events\nt_us,x,y,p\n1500000,3,2,1\n1500001,4,9,0\n2000000,9,0,1\n",
        "1500000,3,2,1,\n1500001,4,9,0,\n2000000,9,0,1,\n",
        "1.500000 3 2 1\n1.500001 4 9 0\n2.000000 9 0 1\n",
        "10 10\n1.500000 3 2 1\n1.500001 4 9 0\n2.000000 9 0 1\n",
        "3,2,1500000,1\n4,9,1500001,-1\n9,0,2000000,1\n",
        "1.500000000000000000e+00 3.000000000000000000e+00 2.0 1.0\n"
            + "1.500000500000000000e+00 4.000000000000000000e+00 9.0 0.0\n"
            + "2.000000000000000000e+00 9.000000000000000000e+00 0.0 1.0\n"
      })
  void columnsAreDeterminedByNamesOrContent(String text) throws IOException {
    assertEquals(expected(), events(text));
  }

  @Test
  void timesAreExactBeyondFloatingPointPrecision() throws IOException {
    EventPacket events =
        events(
            "timestamp_s,x,y,p\n"
                + "1718925184.590631,1,1,1\n"
                + "1718925184.5906324999999999999999999,1,1,1\n"
                + "1718925184.5906325,1,1,1\n"
                + "1718925184.590633000000000000000000000001,1,1,1\n"
                + "9007199254740.993,1,1,1\n");
    long startUs = 1_718_925_184_590_631L;
    assertEquals(startUs, events.timeUs(0));
    assertEquals(startUs + 1, events.timeUs(1));
    assertEquals(startUs + 2, events.timeUs(2), "half a microsecond goes up");
    assertEquals(startUs + 2, events.timeUs(3));
    assertEquals(9_007_199_254_740_993_000L, events.timeUs(4));
  }

  @Test
  void invalidRowsAreSkippedAndCounted() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("damaged.csv"),
            "t_us,x,y,on\n1,2,3,1\n\n# a comment\n2,2,3\nx,2,3,1\n3,2 2,3,1\n4,2,3,1,9\n5,2,,1\n"
                + "5,2,3,1\r6,2,3,1\n"
                + "6,345,259,0\n7,346,1,0\n");
    try (RecordingReader reader = Recordings.open(file, options(DAVIS346))) {
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      EventPacket expected = new EventPacket(0);
      expected.append(1, 2, 256, true);
      expected.append(4, 2, 256, true);
      expected.append(6, 345, 0, false);
      assertEquals(expected, recorder.events());
      assertEquals(5, reader.violations().count(Violation.UNKNOWN_WORD));
      assertEquals(33, reader.violations().firstOffset(Violation.UNKNOWN_WORD));
      assertEquals(1, reader.violations().count(Violation.OUTSIDE_SENSOR));
    }
  }

  @Test
  void sizeComesFromTheFirstLineTheUserOrTheEvents() throws IOException {
    String rows = "1.5 3 2 1\n1.6 200 150 0\n";
    Path file = folder.resolve("size.txt");
    Files.writeString(file, "240 180\n" + rows);
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(240, 180, Origin.TOP), reader.geometry());
    }
    Files.writeString(file, rows);
    try (RecordingReader reader = Recordings.open(file, options(DAVIS346))) {
      assertEquals(DAVIS346, reader.geometry());
    }
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(240, 180, Origin.TOP), reader.geometry());
      assertTrue(reader.remarks().toString().contains("--sensor"), reader.remarks().toString());
    }
  }

  @Test
  void tableInAnotherOrderThanThatOfTimeIsToBeSorted() throws IOException {
    Path file = folder.resolve("by-pixel.csv");
    StringBuilder rows = new StringBuilder("t_us,x,y,on\n");
    for (int i = 0; i < 1000; i++) {
      rows.append(i % 7 * 1_000_000 + i).append(',').append(i / 7).append(",3,1\n");
    }
    Files.writeString(file, rows);
    try (RecordingReader reader = Recordings.open(file, options(DAVIS346))) {
      reader.drainTo(new StreamRecorder());
      assertTrue(reader.remarks().toString().contains("sort"), reader.remarks().toString());
    }
    Files.writeString(file, "t_us,x,y,on\n2000000,1,1,1\n5,1,1,1\n6,1,1,1\n");
    try (RecordingReader reader = Recordings.open(file, options(DAVIS346))) {
      reader.drainTo(new StreamRecorder());
      assertFalse(reader.remarks().toString().contains("sort"), reader.remarks().toString());
    }
  }

  @Test
  void lastRowWithoutALineFeedMayBeLate() throws IOException {
    Path file = folder.resolve("late.csv");
    Files.writeString(file, "t_us,x,y,on\n2000000,1,1,1\n1999990,2,1,1");
    try (RecordingReader reader = Recordings.open(file, options(DAVIS346))) {
      StreamRecorder stream = new StreamRecorder();
      reader.drainTo(stream);
      assertEquals(2, stream.events().size());
      assertEquals(2_000_000, stream.events().lastTimeUs());
      assertEquals(1, reader.violations().count(Violation.OUT_OF_ORDER));
      assertEquals(0, reader.violations().count(Violation.CUT_OFF));
    }
  }

  @Test
  void tableOfTracksIsNoRecordingUnlessTheFormatIsNamed() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("tracks.csv"), "t_us,id,x_px,y_px,events\n10,1,51.16,16.9,0\n");
    assertSame(Support.NONE, format().probe(FileHead.read(file)).support());
    ReadOptions named = options(DAVIS346).withFormat("csv");
    try (RecordingReader reader = Recordings.open(file, named)) {
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertEquals(1, recorder.events().size());
    }
  }

  @ParameterizedTest
  @CsvSource({
    "'t_us,x,y,p\n1,2,3,1\n2,2,3,2\n', its polarities are 1 to 2",
    "'t_us,x,y,p\n1,2,3,up\n2,2,3,down\n', 'its polarities, such as up, are no known words'"
  })
  void unknownPolaritiesAreRejectedByName(String text, String reason) throws IOException {
    Path file = Files.writeString(folder.resolve("unknown.csv"), text.replace("\\n", "\n"));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains(reason), refused.getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-16", "UTF-16LE"})
  void wideTextIsToldToBeSavedAsUtf8(String charset) throws IOException {
    String text = (charset.endsWith("LE") ? "\ufeff" : "") + "t_us,x,y,p\n1,2,3,1\n";
    Path file = Files.write(folder.resolve("wide.csv"), text.getBytes(Charset.forName(charset)));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("save it as UTF-8"), refused.getMessage());
  }

  @Test
  void otherTextIsRejected() throws IOException {
    for (String text :
        List.of(
            "Dear reader,\nthis is a letter.\n",
            "name,age\nmiller,3\n",
            "1,2,3\n4,5,6\n",
            "t_us,x,y,on\r1,2,3,1\r2,2,3,1\r",
            "0.1,0.2,0.3,0.4\n0.2,0.1,0.2,0.1\n",
            "{\"x\": 1}\n",
            "{\"t\":1,\"x\":2,\"y\":3,\"p\":1}\n{\"t\":2,\"x\":2,\"y\":3,\"p\":1}\n",
            "t,x,y,p,label\n1,2,3,1\n2,2,3,1\n",
            "1\n2\n3\n")) {
      Path file = Files.writeString(folder.resolve("other"), text);
      assertSame(Support.NONE, format().probe(FileHead.read(file)).support(), text);
      assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    }
  }
}
