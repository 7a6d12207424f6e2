package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** AEDAT-1.0 keeps the contract of all formats, with and without a header. */
class Aedat1FormatTest extends RecordingFormatContract {
  private static final SensorGeometry DVS128 = new SensorGeometry(128, 128);

  @Override
  protected RecordingFormat format() {
    return new Aedat1Format();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(DVS128);
  }

  @Override
  protected long earliestUs() {
    return Integer.MIN_VALUE;
  }

  @Override
  protected long latestUs() {
    return Integer.MAX_VALUE;
  }

  @Override
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    AedatFile bytes = AedatFile.version1().text("# Timestamps tick is 1 us\r\n");
    for (EventPacket packet : packets) {
      bytes.narrow(packet);
    }
    Files.write(file, bytes.toBytes());
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    byte[] endless = Arrays.copyOf(file, file.length + 200_000);
    Arrays.fill(endless, file.length, endless.length, (byte) '#');
    return List.of(endless, Arrays.copyOfRange(file, 1, file.length));
  }

  @Test
  void headerlessFileIsRecognisedByItsClock() throws IOException {
    EventPacket events = EventPackets.uniform(DVS128, 1, 5000, 679_877_510, 180);
    Path file = AedatFile.empty().narrow(events).in(folder, "headerless.dat");

    assertEquals(Support.PLAUSIBLE, new Aedat1Format().probe(FileHead.read(file)).support());
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals("aedat1", reader.formatName());
      assertFalse(reader.remarks().isEmpty());
      reader.drainTo(recorder);
    }
    assertEquals(events, recorder.events());
  }

  @Test
  void headerOfAnotherFormatBeforeZerosIsNoClock() throws IOException {
    String header = "% format HISTO3D;height=320;width=320\n% end\n";
    Path file = folder.resolve("histogram.raw");
    Files.write(file, Arrays.copyOf(header.getBytes(StandardCharsets.US_ASCII), 6000));
    assertSame(Support.NONE, format().probe(FileHead.read(file)).support());
  }

  @Test
  void headerlessFilesWithALineLikeStartAreRecognised() throws IOException {
    // y = 0x23 gives a first byte '#', the times have no control characters but one line feed.
    for (int lineFeedAt = 3; lineFeedAt < 30; lineFeedAt++) {
      EventPacket packet = new EventPacket(40);
      for (int i = 0; i < 40; i++) {
        // The low byte of one time is a line feed, which ends the "line" with the record.
        int low = i == lineFeedAt ? 0x0a : 0x40 + i;
        packet.append(0x28282000 + (i * 0x100 & 0x7f00) + low, 47, 0x23, true);
      }
      Path file = AedatFile.empty().narrow(packet).in(folder, "line-" + lineFeedAt + ".dat");
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(file, ReadOptions.DEFAULT.withFormat("aedat1"))) {
        reader.drainTo(recorder);
      }
      assertEquals(packet, recorder.events(), "line feed in record " + lineFeedAt);
    }
  }

  @Test
  void externalInputsAreSkippedAndCounted() throws IOException {
    Path file =
        AedatFile.version1()
            .narrow(0x1318, 10)
            .narrow(0x8000, 11)
            .narrow(0x9318, 12)
            .narrow(0x1318, 13)
            .in(folder, "special.dat");
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
      assertEquals(2, reader.violations().count(Violation.OTHER_DATA));
    }
    assertEquals(2, recorder.events().size());
    assertTrue(recorder.events().isOn(0));
    assertEquals(115, recorder.events().x(0));
    assertEquals(0x13, recorder.events().y(0));
  }
}
