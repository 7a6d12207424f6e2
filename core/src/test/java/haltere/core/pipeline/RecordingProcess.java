package haltere.core.pipeline;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Random;

/**
 * The program that {@link KilledRecordingTest} kills: it makes one recording after the other and
 * says on its standard output what it has handed to the recorder.
 */
final class RecordingProcess {
  static final SensorGeometry SENSOR = new SensorGeometry(320, 240);
  static final int QUEUE_PACKETS = 2;

  /** Number of the recording, events handed over, and 1 if it is finished, as 64 bits each. */
  static final int REPORT_BYTES = 24;

  private static final int MAX_RECORDINGS = 10_000;

  private RecordingProcess() {}

  static Path file(Path folder, long recording) {
    return folder.resolve(recording + ".aedat4");
  }

  /** Appends events of a recording; the same numbers make the same events. */
  static void append(EventPacket packet, long recording, long first, int count) {
    for (long number = first; number < first + count; number++) {
      long mixed = (number + (recording << 32)) * 0x9E3779B97F4A7C15L;
      int x = (int) (mixed >>> 40) % SENSOR.width();
      int y = (int) (mixed >>> 20 & 0xfffff) % SENSOR.height();
      packet.append(7 * number, EventAddress.pack(x, y, mixed < 0));
    }
  }

  /**
   * Records until it is killed.
   *
   * @param arguments a folder, a seed, and how packets are compressed
   */
  public static void main(String[] arguments) throws IOException {
    Path folder = Path.of(arguments[0]);
    Random random = new Random(Long.parseLong(arguments[1]));
    Aedat4Compression compression = Aedat4Compression.valueOf(arguments[2]);
    EventPacket packet = new EventPacket(3000);
    for (long recording = 0; recording < MAX_RECORDINGS; recording++) {
      Aedat4Writer writer =
          Aedat4Writer.createInPlace(file(folder, recording), WriteOptions.of(SENSOR), compression);
      try (Recorder recorder =
          new Recorder(
              writer, SENSOR, OverflowPolicy.BLOCK, QUEUE_PACKETS, Duration.ofSeconds(20))) {
        long events = 0;
        for (int packets = random.nextInt(60); packets >= 0; packets--) {
          packet.clear();
          append(packet, recording, events, 1 + random.nextInt(3000));
          recorder.packet(packet);
          events += packet.size();
          report(recording, events, 0);
        }
        recorder.finish();
        report(recording, events, 1);
      }
    }
  }

  private static final FileOutputStream OUT = new FileOutputStream(FileDescriptor.out);
  private static final ByteBuffer BYTES = ByteBuffer.allocate(REPORT_BYTES);

  private static void report(long recording, long events, long finished) throws IOException {
    BYTES.clear().putLong(recording).putLong(events).putLong(finished);
    OUT.write(BYTES.array());
  }
}
