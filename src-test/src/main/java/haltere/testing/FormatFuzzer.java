package haltere.testing;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.TimeSegment;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Contract of a format for arbitrary bytes: they are read to their end within the grammar of
 * streams and sought, or refused with a {@link RecordingProblem}. Nothing else may be thrown.
 *
 * <p>{@code ./gradlew fuzz -Pformat=NAME} has a fuzzer that is guided by coverage look for bytes
 * for which that does not hold (FormatFuzzTest). What it found is kept in the tests' resources and
 * tried anew by the tests.
 *
 * <p>Thread rule: one thread.
 */
public final class FormatFuzzer {
  private static final int PACKET_EVENTS = 500;
  private static final int SEED_BYTES = 16 * 1024;

  /** A file of a few bytes may stand for at most so many steps of a reader; more is a fault. */
  private static final long MAX_STEPS = 2_000_000;

  private static final StreamHandler NOBODY = new StreamRecorderOfNothing();

  private static final class StreamRecorderOfNothing implements StreamHandler {
    @Override
    public void packet(EventPacket packet) {
      // Whether it is one is what the grammar looks at.
    }

    @Override
    public void notified(haltere.core.stream.StreamNotification notification) {
      // As above.
    }
  }

  private FormatFuzzer() {}

  /**
   * Reads bytes as a recording.
   *
   * @param format reads them
   * @param bytes any
   * @param file where they are put
   * @throws IOException if the file cannot be written, or a reader fails as none should
   */
  public static void check(RecordingFormat format, byte[] bytes, Path file) throws IOException {
    ReplacedFile.write(file, bytes);
    ReadOptions options = ReadOptions.DEFAULT.withPacketEvents(PACKET_EVENTS);
    try (RecordingReader reader = format.open(file, options)) {
      reader.outline();
      drain(reader);
      seek(reader);
    } catch (RecordingProblem problem) {
      // the expected result of unreadable bytes
    }
    format.probe(FileHead.read(file));
  }

  private static void drain(RecordingReader reader) throws IOException {
    StreamGrammar grammar = new StreamGrammar(NOBODY);
    long steps = 0;
    while (reader.next(grammar)) {
      if (++steps > MAX_STEPS) {
        throw new IllegalStateException("it does not come to an end");
      }
    }
  }

  private static void seek(RecordingReader reader) throws IOException {
    List<TimeSegment> segments = reader.segments();
    if (segments.isEmpty()) {
      return;
    }
    TimeSegment last = segments.get(segments.size() - 1);
    reader.seek(segments.size() - 1, last.lastUs());
    drain(reader);
    reader.seek(0, last.firstUs());
    reader.next(NOBODY);
  }

  /**
   * Writes small recordings of each format for the fuzzer to start from.
   *
   * @param arguments the folder that gets a folder for each format; one that has folders of inputs
   *     for each format; a folder of recordings
   * @throws IOException if that fails
   */
  public static void main(String[] arguments) throws IOException {
    for (RecordingFormat format : Recordings.formats().values()) {
      Path folder = Files.createDirectories(Path.of(arguments[0], format.name()));
      writeSeeds(format, folder);
      copySeeds(format, Recorded.folder(), folder);
      copySeeds(format, Path.of(arguments[1], format.name()), folder);
      copySeeds(format, Path.of(arguments[2]), folder);
    }
  }

  private static void writeSeeds(RecordingFormat format, Path folder) throws IOException {
    SensorGeometry sensor = new SensorGeometry(34, 30, Origin.TOP);
    for (int events : new int[] {0, 1, 40, 400}) {
      Optional<RecordingWriter> writer =
          format.create(
              folder.resolve("written-" + events), WriteOptions.of(sensor).withOverwrite(true));
      if (writer.isPresent()) {
        try (RecordingWriter open = writer.get()) {
          open.write(EventPackets.uniform(sensor, events, events, 1_000_000, 37));
          open.finish();
        }
      }
    }
  }

  /** Copies the first bytes of the recordings that are of a format. */
  private static void copySeeds(RecordingFormat format, Path from, Path to) throws IOException {
    for (Path recording : files(from)) {
      try {
        if (Recordings.detect(recording) == format) {
          try (InputStream in = Files.newInputStream(recording)) {
            Files.write(to.resolve(recording.getFileName()), in.readNBytes(SEED_BYTES));
          }
        }
      } catch (RecordingProblem problem) {
        // It is no recording.
      }
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (var all = Files.list(folder)) {
      return all.filter(Files::isRegularFile).sorted().toList();
    }
  }
}
