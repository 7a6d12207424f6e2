package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The camera of a file, and the words that are events. */
class AedatSensorTest {
  private static final SensorGeometry DVS128 = new SensorGeometry(128, 128);
  private static final SensorGeometry DAVIS240 = new SensorGeometry(240, 180);

  @TempDir Path folder;

  private RecordingReader open(AedatFile bytes) throws IOException {
    return open(bytes, ReadOptions.DEFAULT);
  }

  private RecordingReader open(AedatFile bytes, ReadOptions options) throws IOException {
    return Recordings.open(bytes.in(folder, "file.aedat"), options);
  }

  private static EventPacket read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(recorder);
    return recorder.events();
  }

  @ParameterizedTest
  @CsvSource({
    "AEChip: ch.unizh.ini.jaer.chip.retina.DVS128, 128x128",
    "AEChip: ch.unizh.ini.caviar.chip.retina.Tmpdiff128, 128x128",
    "AEChip: eu.seebetter.ini.chips.davis.DAVIS240C, 240x180",
    "AEChip: eu.seebetter.ini.chips.sbret10.SBret10, 240x180",
    "AEChip: eu.seebetter.ini.chips.davis.Davis346blue, 346x260",
    "AEChip: eu.seebetter.ini.chips.davis.Davis346B, 346x260",
    "AEChip: eu.seebetter.ini.chips.davis.Davis640, 640x480",
    "AEChip: eu.seebetter.ini.chips.davis.Davis208PixelParade, 208x192",
    "AEChip: eu.seebetter.ini.chips.davis.Davis128, 128x128",
    "HardwareInterface: DVS128-V1 0392, 128x128",
    "Haltere sensor: 77x33, 77x33"
  })
  void headerNamesTheCamera(String line, String size) throws IOException {
    AedatFile bytes = AedatFile.version2().text("# " + line + "\r\n").record(0, 0);
    try (RecordingReader reader = open(bytes)) {
      assertEquals(size, reader.geometry().toString());
      assertEquals(List.of(), reader.remarks());
    }
  }

  @Test
  void headerOverridesTheUser() throws IOException {
    AedatFile bytes =
        AedatFile.version2().text("# AEChip: ch.unizh.ini.jaer.chip.retina.DVS128\r\n");
    try (RecordingReader reader =
        open(bytes.dvs128(1, 100, 90, true), ReadOptions.DEFAULT.withSensor(DAVIS240))) {
      assertEquals(DVS128, reader.geometry());
      assertEquals(100, read(reader).x(0));
    }
  }

  @Test
  void anUnnamedDvs128IsDeterminedByItsAddressesWithARemark() throws IOException {
    try (RecordingReader reader = open(AedatFile.version2().dvs128(1, 100, 90, false))) {
      assertEquals(DVS128, reader.geometry());
      assertEquals(1, reader.remarks().size());
      assertTrue(reader.remarks().get(0).contains("DVS128"), reader.remarks().get(0));
    }
  }

  @Test
  void anUnnamedDavisIsDeterminedByItsAddressesWithRemarks() throws IOException {
    AedatFile bytes = AedatFile.version2().davis240(1, 0, 179, true).davis240(2, 9, 9, true);
    try (RecordingReader reader = open(bytes)) {
      assertEquals(DAVIS240, reader.geometry());
      assertEquals(2, reader.remarks().size());
      assertTrue(reader.remarks().get(1).contains("--sensor"), reader.remarks().get(1));
      assertEquals(179, read(reader).y(0));
    }
    try (RecordingReader reader = open(bytes.record(259 << 22 | 5 << 12, 3))) {
      assertEquals(new SensorGeometry(346, 260), reader.geometry());
    }
    try (RecordingReader reader = open(bytes.record(300 << 22 | 5 << 12, 4))) {
      assertEquals(new SensorGeometry(640, 480), reader.geometry());
    }
    try (RecordingReader reader = open(bytes.record(511 << 22 | 1023 << 12, 5))) {
      assertEquals(new SensorGeometry(1024, 512), reader.geometry());
    }
  }

  @Test
  void layoutIsChosenByTheWholeFileNotItsFirstAddresses() throws IOException {
    AedatFile bytes = AedatFile.version2();
    for (int i = 0; i < 100; i++) {
      bytes.record(i, i);
    }
    for (int i = 100; i < 2000; i++) {
      bytes.davis240(i, i % 240, i % 180, i % 2 == 0);
    }
    try (RecordingReader reader = open(bytes)) {
      assertEquals(DAVIS240, reader.geometry());
      assertTrue(read(reader).size() >= 1900);
    }
  }

  @Test
  void sizeIsGuessedFromTheWholeFile() throws IOException {
    AedatFile bytes = AedatFile.version2();
    for (int i = 0; i < 300_000; i++) {
      bytes.davis240(i, i % 240, i % 180, true);
    }
    try (RecordingReader reader = open(bytes.record(259 << 22 | 345 << 12 | 1 << 11, 300_000))) {
      assertEquals(new SensorGeometry(346, 260), reader.geometry());
      assertEquals(300_001, read(reader).size());
    }
  }

  @Test
  void addressesOfUnknownCamerasAreRejectedWithAdvice() throws IOException {
    AedatFile bytes = AedatFile.version2();
    for (int i = 0; i < 1000; i++) {
      bytes.record(i % 2 == 0 ? 0x0123_4567 : 0x8000_8000, i);
    }
    RecordingProblem refused = assertThrows(RecordingProblem.class, () -> open(bytes).close());
    assertTrue(refused.getMessage().contains("--sensor WxH"), refused.getMessage());
    assertTrue(refused.getMessage().contains("--format"), refused.getMessage());
    open(bytes, ReadOptions.DEFAULT.withSensor(DVS128)).close();
  }

  @Test
  void siliconCochleaIsRejected() throws IOException {
    AedatFile bytes =
        AedatFile.version2()
            .text("# AEChip: ch.unizh.ini.jaer.chip.cochlea.CochleaAMS1c\r\n")
            .record(77, 1);
    RecordingProblem refused = assertThrows(RecordingProblem.class, () -> open(bytes).close());
    assertTrue(refused.getMessage().contains("silicon cochlea"), refused.getMessage());
    open(bytes, ReadOptions.DEFAULT.withFormat("aedat2")).close();
  }

  @Test
  void aStatedSizeMirrorsTheColumnsOfAnUnnamedDavis() throws IOException {
    AedatFile bytes = AedatFile.version2().record(50 << 22 | 10 << 12 | 1 << 11, 5);
    SensorGeometry stated = new SensorGeometry(300, 200);
    try (RecordingReader reader = open(bytes, ReadOptions.DEFAULT.withSensor(stated))) {
      assertEquals(stated, reader.geometry());
      EventPacket events = read(reader);
      assertEquals(289, events.x(0));
      assertEquals(50, events.y(0));
      assertTrue(events.isOn(0));
    }
  }

  @Test
  void eventsOutsideOfAStatedSizeAreCountedAndLeftOut() throws IOException {
    SensorGeometry small = new SensorGeometry(64, 32);
    AedatFile dvs128 =
        AedatFile.version2()
            .dvs128(1, 63, 31, true)
            .dvs128(2, 64, 31, true)
            .dvs128(3, 63, 32, true)
            .dvs128(4, 0, 0, true);
    try (RecordingReader reader = open(dvs128, ReadOptions.DEFAULT.withSensor(small))) {
      assertEquals(small, reader.geometry());
      assertEquals(2, read(reader).size());
      assertEquals(2, reader.violations().count(Violation.OUTSIDE_SENSOR));
      assertEquals(14 + 8, reader.violations().firstOffset(Violation.OUTSIDE_SENSOR));
    }
    AedatFile davis = AedatFile.version2();
    for (int i = 0; i < 5000; i++) {
      davis.record((i % 40) << 22 | (i % 70) << 12, i);
    }
    try (RecordingReader reader = open(davis, ReadOptions.DEFAULT.withSensor(small))) {
      EventPacket events = read(reader);
      long outside = reader.violations().count(Violation.OUTSIDE_SENSOR);
      assertEquals(5000, events.size() + outside);
      assertTrue(outside > 1000, outside + " outside");
      for (int i = 0; i < events.size(); i++) {
        int word = (int) events.timeUs(i);
        assertEquals(63 - word % 70, events.x(i));
        assertEquals(word % 40, events.y(i));
      }
    }
  }

  @Test
  void eventsOutsideTheSensorDoNotAdvanceTheClock() throws IOException {
    AedatFile bytes =
        AedatFile.version2().text("# Haltere sensor: 240x180\n").davis240(100, 1, 1, true);
    bytes.record(500 << 22, 2_000_000_000).record(0x80000000, 1).davis240(200, 1, 1, true);
    try (RecordingReader reader = open(bytes)) {
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertEquals(2, recorder.events().size());
      assertEquals(2, recorder.notifications().size(), "start and end only");
    }
  }

  @Test
  void framesInertialSamplesAndExternalInputsOfADavisAreSkippedAndCounted() throws IOException {
    AedatFile bytes =
        AedatFile.version2().text("# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n");
    int others = 0;
    for (int i = 0; i < 4000; i++) {
      bytes.davis240(10 * i, i % 240, i % 180, i % 2 == 0);
      if (i % 3 == 0) {
        int kind = i / 3 % 3;
        bytes.record(
            kind == 0
                ? 0x80000000 | 20 << 22 | 30 << 12 | 0x400 | 777
                : kind == 1 ? 0x80000c00 | 3 << 28 | 0x1234 << 12 : 0x402,
            10 * i);
        others++;
      }
    }
    try (RecordingReader reader = open(bytes)) {
      EventPacket events = read(reader);
      assertEquals(4000, events.size());
      assertEquals(others, reader.violations().count(Violation.OTHER_DATA));
      for (int i = 0; i < 4000; i++) {
        assertEquals(i % 240, events.x(i));
        assertEquals(i % 180, events.y(i));
        assertEquals(i % 2 == 0, events.isOn(i));
        assertEquals(10L * i, events.timeUs(i));
      }
      reader.seek(0);
      assertEquals(4000, read(reader).size());
      assertEquals(others, reader.violations().count(Violation.OTHER_DATA), "counted once");
    }
  }

  @Test
  void externalInputsOfADvs128AreSkippedAndCounted() throws IOException {
    AedatFile bytes = AedatFile.version2();
    for (int i = 0; i < 3000; i++) {
      bytes.dvs128(i, i % 128, i % 128, true);
    }
    bytes.record(0x8000, 3000).record(0x80000000, 3000).record(0x9318, 3000);
    bytes.record(0x00010000, 3000).dvs128(3001, 5, 5, true);
    try (RecordingReader reader = open(bytes)) {
      assertEquals(3001, read(reader).size());
      assertEquals(3, reader.violations().count(Violation.OTHER_DATA));
      assertEquals(1, reader.violations().count(Violation.UNKNOWN_WORD));
      assertEquals(14 + 3000 * 8, reader.violations().firstOffset(Violation.OTHER_DATA));
    }
  }

  @Test
  void addressesOfBothLayoutsAreReversible() {
    Dvs128AddressDecoder dvs128 = new Dvs128AddressDecoder(DVS128);
    for (int word = 0; word < 0x8000; word++) {
      int address = dvs128.address(word);
      assertEquals(word >> 8, EventAddress.y(address));
      assertEquals(127 - (word >> 1 & 0x7f), EventAddress.x(address));
      assertEquals((word & 1) == 0, EventAddress.isOn(address));
      assertEquals(word, dvs128.word(address));
    }
    DavisAddressDecoder davis = new DavisAddressDecoder(DAVIS240);
    for (int y = 0; y < 180; y++) {
      for (int x = 0; x < 240; x++) {
        int word = y << 22 | x << 12 | (x & 1) << 11;
        int address = davis.address(word);
        assertEquals(239 - x, EventAddress.x(address));
        assertEquals(y, EventAddress.y(address));
        assertEquals(word, davis.word(address));
      }
    }
    assertEquals(AddressDecoder.OUTSIDE, davis.address(180 << 22));
    assertEquals(AddressDecoder.OUTSIDE, davis.address(240 << 12));
  }
}
