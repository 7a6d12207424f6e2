package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.RecordedPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
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
 * Writes and reads AEDAT-4, sixty copies of a recording of a DVXplorer one after the other, in the
 * page cache; figures are million events a second.
 *
 * <p>{@code ./gradlew jmh -Pbench=Aedat4}; started with {@code taskset -c 0}, the figures of one
 * core. Figures to beat on one core: reading 172, 52, 43 (NONE, LZ4, ZSTD: faery 0.7.1 and
 * dv-processing 2.0.4), writing 152, 28, 17; on two cores reading 208, 94, 70 (eventcv 1.0.8).
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class Aedat4Benchmark {
  private static final int COPIES = 60;
  private static final int COPY_EVENTS = 111_954;
  private static final int EVENTS = COPIES * COPY_EVENTS;

  /** Compression of packets. */
  @Param({"NONE", "LZ4", "ZSTD"})
  public Aedat4Compression compression;

  private final EventPacket[] copies = new EventPacket[COPIES];
  private SensorGeometry sensor;
  private Path file;
  private Path target;

  /**
   * Makes the events and a file of them.
   *
   * @throws IOException if that fails
   */
  @Setup(Level.Trial)
  public void prepare() throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = RecordedPackets.DVXPLORER.open()) {
      sensor = reader.geometry();
      reader.drainTo(recorder);
    }
    EventPacket one = recorder.events();
    long spanUs = one.lastTimeUs() - one.firstTimeUs() + 10;
    for (int copy = 0; copy < COPIES; copy++) {
      long[] times = Arrays.copyOf(one.timesUs(), COPY_EVENTS);
      for (int i = 0; i < COPY_EVENTS; i++) {
        times[i] += copy * spanUs;
      }
      copies[copy] = EventPacket.of(times, Arrays.copyOf(one.addresses(), COPY_EVENTS));
    }
    file = Files.createTempFile("haltere-bench", ".aedat4");
    target = Files.createTempFile("haltere-bench", ".aedat4");
    write(file);
  }

  /**
   * Removes the files.
   *
   * @throws IOException if that fails
   */
  @TearDown(Level.Trial)
  public void remove() throws IOException {
    Files.delete(file);
    Files.delete(target);
  }

  private void write(Path path) throws IOException {
    WriteOptions options = WriteOptions.of(sensor).withOverwrite(true);
    try (RecordingWriter writer = Aedat4Writer.create(path, options, compression)) {
      for (EventPacket copy : copies) {
        writer.write(copy);
      }
      writer.finish();
    }
  }

  /**
   * The writer.
   *
   * @throws IOException if writing fails
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public void write() throws IOException {
    write(target);
  }

  /**
   * The reader, with packets of the usual size that nobody looks at.
   *
   * @return number of events
   * @throws IOException if reading fails
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public long read() throws IOException {
    long[] count = new long[1];
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              count[0] += packet.size();
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
    }
    return count[0];
  }
}
