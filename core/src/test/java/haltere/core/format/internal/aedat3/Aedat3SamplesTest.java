package haltere.core.format.internal.aedat3;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.testing.StreamRecorder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Packets of special events, frames and inertial samples of AEDAT-3 files. */
class Aedat3SamplesTest {
  private static final long TURN_US = 1L << 31;

  @TempDir Path folder;
  private final ByteArrayOutputStream file = new ByteArrayOutputStream();

  private void header() {
    file.writeBytes(
        "#!AER-DAT3.1\r\n#Format: RAW\r\n#Source 1: DAVIS240C\r\n#!END-HEADER\r\n"
            .getBytes(StandardCharsets.ISO_8859_1));
  }

  /** A packet of one camera on the second turn of its clock. */
  private void packet(int kind, int eventBytes, ByteBuffer... events) {
    ByteBuffer head =
        ByteBuffer.allocate(PacketHeader.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putShort((short) kind)
            .putShort((short) 1)
            .putInt(eventBytes)
            .putInt(4)
            .putInt(1)
            .putInt(events.length)
            .putInt(events.length)
            .putInt(events.length);
    file.writeBytes(head.array());
    for (ByteBuffer event : events) {
      file.writeBytes(event.array());
    }
  }

  private static ByteBuffer event(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static ByteBuffer special(int type, int time) {
    return event(8).putInt(type << 1 | 1).putInt(time);
  }

  private static ByteBuffer polarity(int time) {
    return event(8).putInt(5 << 17 | 7 << 2 | 3).putInt(time);
  }

  private static ByteBuffer inertial(int bytes, int time) {
    ByteBuffer event = event(bytes).putInt(1).putInt(time);
    for (int i = 1; event.hasRemaining(); i++) {
      event.putFloat(i);
    }
    return event;
  }

  private StreamRecorder read() throws IOException {
    Path path = Files.write(folder.resolve("samples.aedat"), file.toByteArray());
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(path, ReadOptions.DEFAULT.withSamples(true))) {
      reader.drainTo(recorder);
    }
    return recorder;
  }

  @Test
  void specialEventsAreTriggers() throws IOException {
    header();
    packet(PacketHeader.POLARITY, 8, polarity(5), polarity(35));
    packet(
        PacketHeader.SPECIAL,
        8,
        special(0, 1),
        special(2, 10),
        special(7, 20),
        special(11, 30),
        special(12, 40),
        special(15, 50),
        special(16, 60),
        special(1, 70),
        event(8).putInt(2 << 1).putInt(80));

    StreamRecorder stream = read();

    assertEquals(
        List.of(
            new Trigger(TURN_US + 10, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0),
            new Trigger(TURN_US + 20, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING, 1),
            new Trigger(TURN_US + 30, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 2),
            new Trigger(TURN_US + 40, Trigger.Source.SIGNAL_GENERATOR, Trigger.Edge.RISING, 0),
            new Trigger(TURN_US + 50, Trigger.Source.FRAME_READOUT, Trigger.Edge.FALLING, 0),
            new Trigger(TURN_US + 60, Trigger.Source.EXPOSURE, Trigger.Edge.RISING, 0),
            new Trigger(TURN_US + 70, Trigger.Source.CLOCK_RESET, Trigger.Edge.PULSE, 0)),
        stream.samples(Trigger.class));
    assertEquals(1, stream.placedSamples().get(2).eventsBefore());
    assertEquals(2, stream.placedSamples().get(3).eventsBefore());
  }

  @Test
  void inertialSamplesOfSixAndOfNineAxesAreRead() throws IOException {
    header();
    packet(PacketHeader.INERTIAL_6, 36, inertial(36, 10));
    packet(PacketHeader.INERTIAL_9, 48, inertial(48, 20));

    List<InertialSample> samples = read().samples(InertialSample.class);

    assertEquals(
        List.of(
            new InertialSample(TURN_US + 10, 1, 2, 3, 4, 5, 6, 7),
            new InertialSample(TURN_US + 20, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10)),
        samples);
  }

  @Test
  void framesAreReadWithRegionAndColours() throws IOException {
    header();
    ByteBuffer frame = event(36 + 2 * 3 * 3 * 2).putInt(3 << 1 | 1);
    frame.putInt(100).putInt(400).putInt(200).putInt(300).putInt(3).putInt(2).putInt(10);
    frame.putInt(20);
    for (int i = 0; frame.hasRemaining(); i++) {
      frame.putShort((short) (i * 1000));
    }
    packet(PacketHeader.FRAME, frame.capacity(), frame);

    Frame read = read().samples(Frame.class).get(0);

    assertEquals(
        new Frame.Times(TURN_US + 200, TURN_US + 300, TURN_US + 100, TURN_US + 400), read.times());
    assertEquals(10, read.left());
    assertEquals(180 - 20 - 2, read.bottom());
    assertEquals(3, read.channels());
    assertEquals(0, read.value(0, 1, 0));
    assertEquals(1000, read.value(0, 1, 1));
    assertEquals(17_000, read.value(2, 0, 2));
  }

  @Test
  void filesThatEndInsideASampleYieldTheEarlierOnes() throws IOException {
    header();
    packet(PacketHeader.SPECIAL, 8, special(2, 10), special(3, 20));
    packet(PacketHeader.INERTIAL_6, 36, inertial(36, 10), inertial(36, 20));
    byte[] whole = file.toByteArray();
    int most = 0;
    for (int length = whole.length - 100; length < whole.length; length++) {
      file.reset();
      file.write(whole, 0, length);
      int found = read().samples(SensorSample.class).size();
      assertTrue(found >= most && found < 4, found + " of a file cut to " + length);
      most = found;
    }
    assertEquals(3, most);
  }
}
