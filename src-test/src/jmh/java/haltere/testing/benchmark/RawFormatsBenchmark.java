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
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Reads and writes the formats without packing, from and to the page cache: copies of a real
 * recording one after the other, ten million events or more. The figure is {@code events}, million
 * a second.
 *
 * <p>{@code ./gradlew jmh -Pbench=RawFormats}; started with {@code taskset -c 0}, the figures of
 * one core. Figures to beat on one core, reading: EVT2 289, EVT2.1 216, EVT3 69, DAT 249 (evutils
 * 0.3.18, EVT3 expelliarmus 1.1.12), Event Stream 62 (event-stream 1.6.3), CSV 37 (evutils);
 * writing: EVT2 235, DAT 244 (eventcv 1.0.8), EVT3 66 (evutils), Event Stream 75 (event-stream).
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 7, time = 1)
@Fork(1)
public class RawFormatsBenchmark {
  private static final int EVENTS = 10_000_000;

  /** The format, and of which camera the events are. */
  @Param({
    "evt2 gen3-evt2.raw",
    "evt21 gen3-evt2.raw",
    "evt3 imx636-evt3.raw",
    "dat gen4.dat",
    "es dvs.es",
    "csv gen3-evt2.raw",
    "npz gen3-evt2.raw"
  })
  public String recording;

  private String format;
  private SensorGeometry sensor;
  private EventPacket one;
  private int copies;
  private Path file;
  private Path target;

  /** Number of events read or written. */
  @State(Scope.Thread)
  @AuxCounters(AuxCounters.Type.OPERATIONS)
  public static class Counts {
    /** Events. */
    public long events;
  }

  /**
   * Makes the events and a file of them.
   *
   * @throws IOException if that fails
   */
  @Setup(Level.Trial)
  public void prepare() throws IOException {
    String[] words = recording.split(" ");
    format = words[0];
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(Recorded.folder().resolve(words[1]))) {
      sensor = reader.geometry();
      reader.drainTo(recorder);
    }
    one = recorder.events();
    copies = 1 + EVENTS / one.size();
    file = Files.createTempFile("haltere-bench", "." + format);
    target = Files.createTempFile("haltere-bench", "." + format);
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
    long spanUs = one.lastTimeUs() - one.firstTimeUs() + 10;
    EventPacket copy = EventPackets.copy(one);
    WriteOptions options = WriteOptions.of(sensor).withOverwrite(true);
    try (RecordingWriter writer =
        Recordings.formats().get(format).create(path, options).orElseThrow()) {
      for (int i = 0; i < copies; i++) {
        writer.write(copy);
        for (int event = 0; event < copy.size(); event++) {
          copy.timesUs()[event] += spanUs;
        }
      }
      writer.finish();
    }
  }

  /**
   * The writer, and the loop that shifts the times of the copies.
   *
   * @param counts of events
   * @throws IOException if writing fails
   */
  @Benchmark
  public void write(Counts counts) throws IOException {
    write(target);
    counts.events += (long) copies * one.size();
  }

  /**
   * The reader, with packets of the usual size that nobody looks at.
   *
   * @param counts of events
   * @throws IOException if reading fails
   */
  @Benchmark
  public void read(Counts counts) throws IOException {
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withFormat(format).withSensor(sensor))) {
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              counts.events += packet.size();
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
    }
  }
}
