package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Headers of existing files, and the start of the records behind them. */
class AedatHeaderTest {
  @TempDir Path folder;

  private static AedatFile threeEvents(AedatFile header) {
    return header
        .dvs128(100, 1, 2, true)
        .dvs128(200, 3, 4, false)
        .dvs128(300, 5, 6, true)
        .dvs128(400, 7, 8, true);
  }

  private EventPacket read(AedatFile bytes) throws IOException {
    Path file = bytes.in(folder, "file.aedat");
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
      assertEquals(List.of(), reader.violations().describe());
    }
    return recorder.events();
  }

  private static EventPacket expected() {
    EventPacket events = new EventPacket(4);
    events.append(100, 1, 2, true);
    events.append(200, 3, 4, false);
    events.append(300, 5, 6, true);
    events.append(400, 7, 8, true);
    return events;
  }

  @ParameterizedTest
  @ValueSource(strings = {"\n", "\r\n"})
  void linesMayEndInLineFeedsWithOrWithoutCarriageReturns(String end) throws IOException {
    String header = "#!AER-DAT2.0" + end + "# a remark" + end + "#" + end + "#\tindented" + end;
    assertEquals(expected(), read(threeEvents(AedatFile.empty().text(header))));
    assertEquals(
        expected(),
        read(threeEvents(AedatFile.empty().text(header + "#End Of ASCII Header" + end))));
  }

  @Test
  void lineEndsMayBeMixedInOneHeader() throws IOException {
    assertEquals(
        expected(),
        read(threeEvents(AedatFile.version2().text("# from Windows\r\n# from Linux\n#x\r\n"))));
  }

  @Test
  void bytesBeyondAsciiAreCountedAsBytes() throws IOException {
    byte[] utf8 = "# Zürich, 23 °C, 早い\r\n".getBytes(StandardCharsets.UTF_8);
    byte[] latin = "# Zürich\r\n".getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(expected(), read(threeEvents(AedatFile.version2().raw(utf8).raw(latin))));
  }

  @Test
  void versionLineAloneIsAValidHeader() throws IOException {
    assertEquals(expected(), read(threeEvents(AedatFile.version2())));
  }

  @Test
  void firstVersionLineCounts() throws IOException {
    AedatFile bytes = AedatFile.version1().text("#!AER-DAT2.0 is what this was made from\r\n");
    bytes.narrow(0x1318, 10).narrow(0x1318, 20);
    assertEquals(2, read(bytes).size());
    assertEquals(
        expected(),
        read(threeEvents(AedatFile.version2().text("# was #!AER-DAT1.0\r\n#!AER-DAT1.0\r\n"))));
  }

  @Test
  void versionLineMayHaveAMinorPartAndBlanks() throws IOException {
    assertEquals(expected(), read(threeEvents(AedatFile.empty().text("#!AER-DAT2.1 \n"))));
    assertEquals(expected(), read(threeEvents(AedatFile.empty().text("#!AER-DAT2\r\n"))));
  }

  @Test
  void unknownVersionIsRejectedWithItsNumber() throws IOException {
    Path file = AedatFile.empty().text("#!AER-DAT5.1\r\n").in(folder, "three.aedat");
    RecordingProblem unknown = assertThrows(RecordingProblem.class, () -> Recordings.open(file));
    assertTrue(unknown.getMessage().contains("AEDAT-5.1"), unknown.getMessage());
    for (String format : List.of("aedat1", "aedat2")) {
      ReadOptions forced = ReadOptions.DEFAULT.withFormat(format);
      RecordingProblem refused =
          assertThrows(RecordingProblem.class, () -> Recordings.open(file, forced));
      assertTrue(refused.getMessage().contains("5.1"), refused.getMessage());
    }
  }

  @Test
  void recordAfterTheEndLineMayStartWithANumberSign() throws IOException {
    AedatFile bytes =
        AedatFile.version2().text("# Haltere sensor: 1024x512\r\n#End Of ASCII Header\r\n");
    // Every byte of these records is that of some text, and they hold a line feed.
    EventPacket events =
        read(
            bytes
                .record(0x23232000 | 0x2020, 0x20202020)
                .record(0x23232000 | 0x2020, 0x20202a0a)
                .davis240(0x20202a0b, 3, 4, true));
    assertEquals(3, events.size());
    assertEquals(0x23232020 >>> 22, events.y(0));
  }

  @Test
  void davisRecordMayStartWithANumberSignWithoutAnEndLine() throws IOException {
    AedatFile bytes =
        AedatFile.version2().text("# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n");
    for (int i = 0; i < 20; i++) {
      bytes.davis240(0x20202020 + 0x101 * i, 100 + i, 0x23 << 2, i % 2 == 0);
    }
    EventPacket events = read(bytes);
    assertEquals(20, events.size());
    assertEquals(0x23 << 2, events.y(0));
    assertEquals(100, events.x(0));
  }

  @Test
  void recordLikeALineIsRecognisedByTheClockWithoutAnEndLine() throws IOException {
    for (int lineFeedAt = 0; lineFeedAt < 20; lineFeedAt++) {
      AedatFile bytes = AedatFile.version1().text("# Timestamps tick is 1 us\r\n");
      for (int i = 0; i < 25; i++) {
        bytes.narrow(0x2322, i == lineFeedAt ? 0x2828_3a0a + (i << 8) : 0x2828_3a40 + (i << 8));
      }
      EventPacket events = read(bytes);
      assertEquals(25, events.size(), "line feed in record " + lineFeedAt);
      assertEquals(0x23, events.y(0));
    }
  }

  @Test
  void lineOfTheLengthOfRecordsIsALine() throws IOException {
    for (int length = 0; length < 40; length++) {
      AedatFile bytes = AedatFile.version2().text("#" + "x".repeat(length) + "\r\n");
      for (int i = 0; i < 100; i++) {
        bytes.dvs128(1_000_000 + i, i, i, true);
      }
      assertEquals(100, read(bytes).size(), length + " characters");
    }
  }

  @Test
  void anEventAtTimeZeroIsRead() throws IOException {
    EventPacket events =
        read(AedatFile.version2().dvs128(0, 1, 1, true).dvs128(0, 2, 2, true).record(0, 0));
    assertEquals(3, events.size());
    assertEquals(0, events.timeUs(2));
    assertEquals(127, events.x(2));
  }

  @Test
  void fileTruncatedInARecordIsReadUpToItAndReported() throws IOException {
    byte[] whole = threeEvents(AedatFile.version2()).toBytes();
    for (int missing = 1; missing < 8; missing++) {
      Path file =
          AedatFile.empty()
              .raw(java.util.Arrays.copyOf(whole, whole.length - missing))
              .in(folder, "cut.aedat");
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader = Recordings.open(file)) {
        reader.drainTo(recorder);
        assertEquals(1, reader.violations().count(Violation.CUT_OFF));
        assertEquals(whole.length - 8, reader.violations().firstOffset(Violation.CUT_OFF));
        reader.seek(0);
        reader.drainTo(recorder);
        assertEquals(1, reader.violations().count(Violation.CUT_OFF), "counted once");
      }
      assertEquals(6, recorder.events().size());
    }
  }

  @Test
  void headerLongerThanTheFirstReadIsRead() throws IOException {
    AedatFile bytes = AedatFile.version2();
    String line = "# <entry key=\"DVS128.IPot.cas\" value=\"54\"/>\r\n";
    bytes.text(line.repeat(700_000 / line.length()));
    bytes.text("# AEChip: eu.seebetter.ini.chips.davis.Davis346blue\r\n");
    Path file = bytes.davis240(5, 1, 1, true).in(folder, "long.aedat");
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(346, 260), reader.geometry());
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertEquals(1, recorder.events().size());
    }
  }

  @Test
  void endlessHeaderIsRejected() throws IOException {
    String line = "# nothing but text, line after line after line after line after line\n";
    AedatFile bytes = AedatFile.version2().text(line.repeat((17 << 20) / line.length()));
    Path file = bytes.in(folder, "text.aedat");
    RecordingProblem refused = assertThrows(RecordingProblem.class, () -> Recordings.open(file));
    assertTrue(refused.getMessage().contains("does not end"), refused.getMessage());
  }
}
