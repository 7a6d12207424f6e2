package haltere.core.format.internal.nmnist;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** N-MNIST keeps the contract of all formats as far as files without a signature can. */
class NmnistFormatTest extends RecordingFormatContract {
  private static final SensorGeometry CALTECH = new SensorGeometry(240, 180, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new NmnistFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(new SensorGeometry(34, 34), CALTECH, new SensorGeometry(256, 240));
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return (1 << 23) - 1;
  }

  @Override
  protected Support certainty() {
    return Support.PLAUSIBLE;
  }

  @Override
  protected ReadOptions options(SensorGeometry sensor) {
    return ReadOptions.DEFAULT.withSensor(sensor);
  }

  private static void put(ByteBuffer bytes, long timeUs, int x, int row, boolean on) {
    bytes.put((byte) x).put((byte) row);
    bytes.put((byte) (timeUs >> 16 & 0x7f | (on ? 0x80 : 0)));
    bytes.putShort((short) timeUs);
  }

  @Override
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(5 * EventPackets.join(List.of(packets)).size());
    for (EventPacket packet : packets) {
      for (int i = 0; i < packet.size(); i++) {
        int row = sensor.height() - 1 - packet.y(i);
        put(bytes, packet.timeUs(i), packet.x(i), row, packet.isOn(i));
      }
    }
    Files.write(file, bytes.array());
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    byte[] noise = new byte[1_000_000];
    Arrays.fill(noise, (byte) 0xff);
    byte[] overflows = new byte[1_000_000];
    Arrays.fill(overflows, (byte) 240);
    return List.of(Arrays.copyOfRange(file, 1, file.length), noise, overflows);
  }

  private static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(recorder);
    return recorder;
  }

  @Test
  void unstatedSizeIsTheSmallestOfTheDataSets() throws IOException {
    for (SensorGeometry sensor : List.of(CALTECH, new SensorGeometry(34, 34, Origin.TOP))) {
      EventPacket written = EventPackets.uniform(sensor, 1, 5000, 0, 20);
      Path file = folder.resolve("size-" + sensor);
      write(file, sensor, written);
      try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
        assertEquals(sensor, reader.geometry());
        assertEquals(1, reader.remarks().size());
        assertEquals(written, read(reader).events());
      }
    }
  }

  @Test
  void row240AdvancesTheClock() throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(25);
    put(bytes, 100, 1, 33, true);
    put(bytes, 101, 0, 240, false);
    put(bytes, 102, 2, 32, false);
    put(bytes, 0, 0, 240, false);
    put(bytes, 103, 3, 31, true);
    Path file = Files.write(folder.resolve("overflow.bin"), bytes.array());
    try (RecordingReader reader = format().open(file, options(sensors().get(0)))) {
      EventPacket expected = new EventPacket(0);
      expected.append(100, 1, 0, true);
      expected.append(102 + 8192, 2, 1, false);
      expected.append(103 + 2 * 8192, 3, 2, true);
      assertEquals(expected, read(reader).events());
      assertEquals(2, reader.violations().count(Violation.OTHER_DATA));
    }
  }

  @Test
  void clockWraps() throws IOException {
    EventPacket written = EventPackets.uniform(CALTECH, 1, 2000, 8_000_000, 2000);
    Path file = folder.resolve("wrap.bin");
    write(file, CALTECH, written);
    try (RecordingReader reader = format().open(file, options(CALTECH))) {
      assertEquals(written, read(reader).events());
    }
  }

  @Test
  void otherFilesAreNotRecognised() throws IOException {
    byte[] noise = new byte[10_000];
    new java.util.Random(1).nextBytes(noise);
    Path file = Files.write(folder.resolve("noise.bin"), noise);
    assertSame(Support.NONE, format().probe(FileHead.read(file)).support());
  }
}
