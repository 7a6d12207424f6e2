package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Small undamaged files of every format: written, put together where a format is only read, or
 * other programs' bags.
 */
final class SmallFiles {
  private static final int EVENTS = 120;
  private static final int NMNIST_BYTES = 5;
  private static final Path BAGS = Path.of("src/test/resources/bags");
  private static final SensorGeometry DVS128 = new SensorGeometry(128, 128);
  private static final SensorGeometry SMALL = new SensorGeometry(64, 48, Origin.TOP);

  private SmallFiles() {}

  /** The sensor of the files of a format. */
  static SensorGeometry sensor(RecordingFormat format) {
    return format.name().equals("aedat1") || format.name().equals("aedat2") ? DVS128 : SMALL;
  }

  /** Bytes of a file, another one for each number where there are several. */
  static byte[] bytes(RecordingFormat format, int number, Path folder) throws IOException {
    if (format.writable()) {
      return written(format, events(sensor(format), number), folder.resolve("written"));
    }
    return switch (format.name()) {
      case "aedat1" -> aedat1(events(DVS128, number));
      case "aedat3" -> aedat3(events(SMALL, number));
      case "nmnist" ->
          Arrays.copyOf(
              Files.readAllBytes(Recorded.file("nmnist-sample.bin")), EVENTS * NMNIST_BYTES);
      case "rosbag" ->
          Files.readAllBytes(BAGS.resolve(number % 2 == 0 ? "array-lz4.bag" : "libcaer.bag"));
      case "rosbag2" -> Files.readAllBytes(BAGS.resolve("array.db3"));
      default -> throw new IllegalArgumentException("there is no small file of " + format.name());
    };
  }

  private static EventPacket events(SensorGeometry sensor, int number) {
    EventPacket events = EventPackets.uniform(sensor, number, EVENTS, 1000L * number, 40);
    for (int i = 0; i < events.size(); i++) {
      // Some at the same time and in neighbouring columns, so that there are vectors.
      events.timesUs()[i] -= events.timesUs()[i] % 256;
    }
    return events;
  }

  private static byte[] written(RecordingFormat format, EventPacket events, Path file)
      throws IOException {
    WriteOptions options = WriteOptions.of(sensor(format)).withOverwrite(true);
    try (RecordingWriter writer = format.create(file, options).orElseThrow()) {
      writer.write(events);
      writer.finish();
    }
    return Files.readAllBytes(file);
  }

  private static ByteBuffer after(String header, int bytes) {
    byte[] text = header.getBytes(StandardCharsets.US_ASCII);
    return ByteBuffer.allocate(text.length + bytes).put(text);
  }

  private static byte[] aedat1(EventPacket events) {
    ByteBuffer bytes = after("#!AER-DAT1.0\r\n# Timestamps tick is 1 us\r\n", events.size() * 6);
    for (int i = 0; i < events.size(); i++) {
      int word = events.y(i) << 8 | (127 - events.x(i)) << 1 | (events.isOn(i) ? 0 : 1);
      bytes.putShort((short) word).putInt((int) events.timeUs(i));
    }
    return bytes.array();
  }

  private static byte[] aedat3(EventPacket events) {
    String header = "#!AER-DAT3.1\r\n#Format: RAW\r\n#Source 1: unknown\r\n#!END-HEADER\r\n";
    int most = 30;
    ByteBuffer bytes = after(header, events.size() * 8 + 28 * ((events.size() + most - 1) / most));
    bytes.order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < events.size(); i++) {
      if (i % most == 0) {
        int number = Math.min(most, events.size() - i);
        bytes.putShort((short) 1).putShort((short) 1).putInt(8).putInt(4).putInt(0);
        bytes.putInt(number).putInt(number).putInt(number);
      }
      int y = SMALL.height() - 1 - events.y(i);
      bytes.putInt(events.x(i) << 17 | y << 2 | (events.isOn(i) ? 2 : 0) | 1);
      bytes.putInt((int) events.timeUs(i));
    }
    return bytes.array();
  }
}
