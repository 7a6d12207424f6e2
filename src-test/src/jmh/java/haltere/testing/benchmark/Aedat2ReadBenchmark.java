package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Reads an AEDAT-2.0 file from the page cache: through {@link Recordings}, and beside it the least
 * that any reader must do, a loop over the same bytes, mapped, that only adds the records up.
 *
 * <p>{@code ./gradlew jmh -Pbench=Aedat2Read}; figures are million records a second. What you
 * should see: decoding at half of the plain loop or better, for DAVIS cameras somewhat slower than
 * for the DVS128. Figures to beat on one core: 66 for the DVS128 (tonic 1.7.0) and 64 for the DAVIS
 * (eventcv 1.0.8).
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class Aedat2ReadBenchmark {
  private static final int RECORDS = 20_000_000;

  /** The camera; {@code davis-frames} has one word of a frame after every seven events. */
  @Param({"dvs128", "davis346", "davis-frames"})
  public String camera;

  private Path file;
  private long records;

  /**
   * Writes the file.
   *
   * @throws IOException if that fails
   */
  @Setup(Level.Trial)
  public void write() throws IOException {
    boolean dvs128 = camera.equals("dvs128");
    SensorGeometry sensor = dvs128 ? new SensorGeometry(128, 128) : new SensorGeometry(346, 260);
    file = Files.createTempFile("haltere-bench", ".aedat");
    SplittableRandom random = new SplittableRandom(1);
    EventPacket packet = new EventPacket(1 << 16);
    try (RecordingWriter writer =
        Recordings.forWriting(file)
            .create(file, WriteOptions.of(sensor).withOverwrite(true))
            .orElseThrow()) {
      long timeUs = 0;
      for (int done = 0; done < RECORDS; done += packet.size()) {
        packet.clear();
        while (packet.size() < 1 << 16 && done + packet.size() < RECORDS) {
          timeUs += random.nextInt(3);
          packet.append(
              timeUs,
              random.nextInt(sensor.width()),
              random.nextInt(sensor.height()),
              random.nextBoolean());
        }
        writer.write(packet);
      }
      writer.finish();
    }
    if (camera.equals("davis-frames")) {
      addFrames();
    }
    records = RECORDS;
  }

  /** Turns every eighth record into a pixel sample. */
  private void addFrames() throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    long data = bytes.length - 8L * RECORDS;
    for (long at = data + 56; at < bytes.length; at += 64) {
      bytes[(int) at] |= (byte) 0x80;
    }
    Files.write(file, bytes);
  }

  /**
   * Removes the file.
   *
   * @throws IOException if that fails
   */
  @TearDown(Level.Trial)
  public void remove() throws IOException {
    Files.delete(file);
  }

  /**
   * The plain loop over the mapped bytes.
   *
   * @return sum of the records
   * @throws IOException if reading fails
   */
  @Benchmark
  @OperationsPerInvocation(RECORDS)
  public long plainLoop() throws IOException {
    try (FileChannel channel = FileChannel.open(file)) {
      ByteBuffer bytes = channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size());
      LongBuffer words =
          bytes.position((int) (channel.size() - 8 * records)).slice().asLongBuffer();
      long sum = 0;
      int size = words.limit();
      for (int i = 0; i < size; i++) {
        sum += words.get(i);
      }
      return sum;
    }
  }

  /**
   * The reader, with packets of the usual size that nobody looks at.
   *
   * @return number of events
   * @throws IOException if reading fails
   */
  @Benchmark
  @OperationsPerInvocation(RECORDS)
  public long decode() throws IOException {
    return drain(new Counter(false));
  }

  /**
   * The reader, and a loop by index over each packet's events.
   *
   * @return sum over the events
   * @throws IOException if reading fails
   */
  @Benchmark
  @OperationsPerInvocation(RECORDS)
  public long decodeAndLoop() throws IOException {
    return drain(new Counter(true));
  }

  private long drain(Counter counter) throws IOException {
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT)) {
      reader.drainTo(counter);
    }
    return counter.count;
  }

  private static final class Counter implements StreamHandler {
    private final boolean loop;
    private long count;

    Counter(boolean loop) {
      this.loop = loop;
    }

    @Override
    public void packet(EventPacket packet) {
      int size = packet.size();
      if (!loop) {
        count += size;
        return;
      }
      long sum = 0;
      for (int i = 0; i < size; i++) {
        sum += packet.timeUs(i) + packet.x(i) + packet.y(i) + (packet.isOn(i) ? 1 : 0);
      }
      count += sum;
    }

    @Override
    public void notified(StreamNotification notification) {}
  }
}
