package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.stream.Reset;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Frames, inertial samples and external inputs among the records of AEDAT-1.0 and AEDAT-2.0. */
class AedatSamplesTest {
  private static final int APS = 0x8000_0000;
  private static final int SIGNAL = 1 << 10;
  private static final int WIDTH = 240;
  private static final int HEIGHT = 180;

  @TempDir Path folder;
  private long incomplete;
  private List<String> remarks;

  private static AedatFile davis() {
    return AedatFile.version2().text("# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n");
  }

  private StreamRecorder read(AedatFile content) throws IOException {
    Path file = Files.write(folder.resolve("samples.aedat"), content.toBytes());
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSamples(true))) {
      reader.drainTo(recorder);
      remarks = reader.remarks();
      incomplete = reader.violations().count(Violation.INCOMPLETE_SAMPLE);
    }
    return recorder;
  }

  private static int sample(int x, int y, boolean signal, int value) {
    return APS | y << 22 | x << 12 | (signal ? SIGNAL : 0) | value;
  }

  /** Value of a pixel in the frames of these tests. */
  private static int brightness(int x, int y) {
    return (x * 3 + y) % 500;
  }

  /** One reading of all pixels of a region, a microsecond for each column. */
  private static void readOut(
      AedatFile file, int time, boolean signal, int left, int right, int bottom, int top) {
    for (int x = left; x <= right; x++) {
      for (int y = top; y >= bottom; y--) {
        int value = 700 - (signal ? brightness(x, y) : 0);
        file.record(sample(x, y, signal, value), time + x - left);
      }
    }
  }

  private static void checkPixels(Frame frame) {
    for (int x = 0; x < frame.width(); x++) {
      for (int y = 0; y < frame.height(); y++) {
        int expected = brightness(x + frame.left(), y + frame.bottom()) << 6;
        assertEquals(expected, frame.value(x, y, 0), "pixel " + x + ", " + y);
      }
    }
  }

  @Test
  void framesAreResetMinusSignal() throws IOException {
    AedatFile file = davis().davis240(900, 1, 1, true);
    readOut(file, 1000, false, 0, WIDTH - 1, 0, HEIGHT - 1);
    file.davis240(5000, 2, 2, true);
    readOut(file, 9000, true, 0, WIDTH - 1, 0, HEIGHT - 1);
    file.davis240(9500, 3, 3, true);

    StreamRecorder stream = read(file);

    Frame frame = stream.samples(Frame.class).get(0);
    assertEquals(1, stream.placedSamples().get(0).eventsBefore());
    assertEquals(new Frame.Times(1000, 9000, 1000, 9239), frame.times());
    assertEquals("240x180x1 UNSIGNED_16 frame at 1000 us", frame.toString());
    checkPixels(frame);
    assertEquals(0, incomplete);
  }

  @Test
  void nextFrameEndsARegionOfInterest() throws IOException {
    AedatFile file = davis();
    for (int start = 1000; start <= 5000; start += 2000) {
      readOut(file, start, false, 100, 139, 50, 79);
      readOut(file, start + 1000, true, 100, 139, 50, 79);
    }

    List<Frame> frames = read(file).samples(Frame.class);

    assertEquals(2, frames.size(), "nothing tells that the last one is whole");
    assertEquals(100, frames.get(1).left());
    assertEquals(50, frames.get(1).bottom());
    assertEquals("40x30x1 UNSIGNED_16 frame at 3000 us", frames.get(1).toString());
    checkPixels(frames.get(1));
  }

  @Test
  void recordingsThatStartInsideAFrameYieldTheNextFrames() throws IOException {
    AedatFile file = davis();
    readOut(file, 500, true, 100, WIDTH - 1, 0, HEIGHT - 1);
    readOut(file, 1000, false, 0, WIDTH - 1, 0, HEIGHT - 1);
    readOut(file, 2000, true, 0, WIDTH - 1, 0, HEIGHT - 1);

    List<Frame> frames = read(file).samples(Frame.class);

    assertEquals(1, frames.size());
    checkPixels(frames.get(0));
    assertEquals(1, incomplete);
  }

  @Test
  void sevenWordsAreAnInertialSample() throws IOException {
    AedatFile file = davis().text("# \"ImuAccelScaleG2\" \"GyroFullScaleDegPerSec250\"\r\n");
    int[] values = {16384, -16384, 1, 340, 32767, -32768, 0};
    for (int round = 0; round < 2; round++) {
      for (int code = round; code < 7; code++) {
        file.record(APS | code << 28 | (values[code] & 0xffff) << 12 | 0xc00, 50);
      }
    }

    List<InertialSample> samples = read(file).samples(InertialSample.class);

    float least = 250 / 32768f;
    assertEquals(
        List.of(new InertialSample(50, 1, -1, 2 / 32768f, 32767 * least, -250, 0, 36)), samples);
    assertEquals(6, incomplete);
  }

  @Test
  void assumedRangeIsStatedOnlyForInertialSamples() throws IOException {
    AedatFile withFrames = davis();
    readOut(withFrames, 1000, false, 0, WIDTH - 1, 0, HEIGHT - 1);
    read(withFrames);
    assertEquals(List.of(), remarks);

    AedatFile withInertial = davis();
    for (int code = 0; code < 7; code++) {
      withInertial.record(APS | code << 28 | 0xc00, 50);
    }
    read(withInertial);
    assertEquals(1, remarks.size());
    assertTrue(remarks.get(0).contains("range of the inertial sensor"), remarks.get(0));
  }

  @Test
  void davisTriggersHaveTheirEdge() throws IOException {
    AedatFile file = davis();
    file.record(0x402, 10).record(0x403, 20).record(0x404, 30).davis240(30, 1, 1, true);

    StreamRecorder stream = read(file);

    assertEquals(
        List.of(
            new Trigger(10, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0),
            new Trigger(20, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING, 0),
            new Trigger(30, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 0)),
        stream.samples(Trigger.class));
    assertEquals(0, stream.placedSamples().get(2).eventsBefore());
  }

  @Test
  void dvs128TriggersAreReadFromBothVersions() throws IOException {
    Trigger expected = new Trigger(15, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 0);
    AedatFile two = AedatFile.version2().text("# AEChip: DVS128\r\n").dvs128(10, 1, 1, true);
    two.record(0x8001, 15).dvs128(20, 2, 2, true);
    AedatFile one = AedatFile.version1().narrow(0x102, 10).narrow(0x8001, 15).narrow(0x204, 20);
    for (AedatFile file : List.of(two, one)) {
      StreamRecorder stream = read(file);
      assertEquals(2, stream.events().size());
      assertEquals(List.of(new StreamRecorder.Read(1, expected)), stream.placedSamples());
    }
  }

  @Test
  void samplesStayOnTheirSideOfAClockRestart() throws IOException {
    AedatFile file = davis();
    for (int pass = 0; pass < 3; pass++) {
      file.record(0x402, 7_000_000).davis240(8_000_000 + pass, 1, 1, true);
      file.record(0x403, 9_000_000).record(0x402, 10 + pass).davis240(1_000_000, 2, 2, true);
      file.record(0x403, 2_000_000);
    }

    StreamRecorder stream = read(file);

    List<String> places =
        stream.placedSamples().stream()
            .map(read -> read.eventsBefore() + ":" + read.sample().timeUs())
            .toList();
    assertEquals(
        List.of(
            "0:7000000",
            "1:9000000",
            "1:10",
            "2:2000000",
            "2:7000000",
            "3:9000000",
            "3:11",
            "4:2000000",
            "4:7000000",
            "5:9000000",
            "5:12",
            "6:2000000"),
        places);
    assertEquals(3, stream.notifications(Reset.class).size());
  }

  @Test
  void samplesAreDeliveredOnlyOnRequest() throws IOException {
    Path file = folder.resolve("events.aedat");
    Files.write(file, davis().record(0x402, 1).davis240(2, 1, 1, true).toBytes());
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
    }
    assertEquals(List.of(), recorder.samples(SensorSample.class));
  }
}
