package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Files cut, changed, lengthened and filled up at random, the same at every run: nothing but a
 * problem in words may come of them, and the events before the damage are the true ones.
 */
class DamagedFilesTest {
  private static final int CASES = 800;
  private static final int EVENTS = 120;
  private static final Duration SOON = Duration.ofSeconds(60);
  private static final SensorGeometry SENSOR = new SensorGeometry(64, 48, Origin.TOP);

  @TempDir Path folder;

  private static EventPacket events(long seed) {
    EventPacket events = EventPackets.uniform(SENSOR, seed, EVENTS, 1000 * seed, 40);
    for (int i = 0; i < events.size(); i++) {
      // Some at the same time and in neighbouring columns, so that there are vectors.
      events.timesUs()[i] -= events.timesUs()[i] % 256;
    }
    return events;
  }

  private byte[] trueFile(RecordingFormat format, long seed) throws IOException {
    Path file = folder.resolve("true-" + seed);
    if (!format.writable()) {
      byte[] sample = Files.readAllBytes(Recorded.file("nmnist-sample.bin"));
      return Arrays.copyOf(sample, EVENTS * 5);
    }
    try (RecordingWriter writer =
        format.create(file, WriteOptions.of(SENSOR).withOverwrite(true)).orElseThrow()) {
      writer.write(events(seed));
      writer.finish();
    }
    return Files.readAllBytes(file);
  }

  /** A damaged copy, and the first byte that is not as it was. */
  private record Damage(byte[] bytes, int at) {}

  private static Damage damage(byte[] whole, SplittableRandom random) {
    int at = random.nextInt(whole.length);
    switch (random.nextInt(5)) {
      case 0:
        return new Damage(Arrays.copyOf(whole, at), at);
      case 1:
        byte[] flipped = whole.clone();
        int first = whole.length;
        for (int i = random.nextInt(1, 9); i > 0; i--) {
          int place = random.nextInt(whole.length);
          flipped[place] ^= (byte) (1 << random.nextInt(8));
          first = Math.min(first, place);
        }
        return new Damage(flipped, first);
      case 2:
        byte[] inserted = new byte[random.nextInt(1, 40)];
        random.nextBytes(inserted);
        return new Damage(joined(whole, at, inserted, at), at);
      case 3:
        byte[] filler = new byte[random.nextInt(1, 20_000)];
        Arrays.fill(filler, (byte) random.nextInt(256));
        return new Damage(joined(whole, at, filler, at), at);
      default:
        int lost = Math.min(whole.length, at + random.nextInt(1, 30));
        return new Damage(joined(whole, at, new byte[0], lost), at);
    }
  }

  private static byte[] joined(byte[] whole, int to, byte[] between, int from) {
    return ByteBuffer.allocate(to + between.length + whole.length - from)
        .put(whole, 0, to)
        .put(between)
        .put(whole, from, whole.length - from)
        .array();
  }

  private EventPacket read(RecordingFormat format, byte[] bytes) throws IOException {
    Path file = Files.write(folder.resolve("damaged"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = format.open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
      reader.drainTo(new StreamGrammar(recorder));
      List<TimeSegment> segments = reader.segments();
      assertEquals(recorder.events().isEmpty(), segments.isEmpty());
      for (String line : reader.violations().describe()) {
        assertTrue(line.contains("byte "), line);
      }
    }
    return recorder.events();
  }

  /** Where the header ends; damage before it may make another recording of the file. */
  private static int headerBytes(String name, byte[] whole) {
    String text = new String(whole, StandardCharsets.ISO_8859_1);
    return switch (name) {
      case "evt2", "evt21", "evt3" -> text.indexOf("% end\n") + 6;
      case "dat" -> text.indexOf("\n\f\b") + 3;
      case "es" -> 20;
      case "npz", "hdf5" -> whole.length;
      case "csv" -> text.indexOf('\n') + 1;
      default -> 0;
    };
  }

  @ParameterizedTest
  @ValueSource(strings = {"evt2", "evt21", "evt3", "dat", "es", "csv", "nmnist", "npz", "hdf5"})
  void damageIsFoundAndWhatWasBeforeItIsRead(String name) {
    RecordingFormat format = Recordings.formats().get(name);
    assertTimeout(
        SOON,
        () -> {
          SplittableRandom random = new SplittableRandom(name.hashCode());
          List<Integer> read = new ArrayList<>();
          for (int i = 0; i < CASES; i++) {
            byte[] whole = trueFile(format, i % 7 + 1);
            Damage damage = damage(whole, random);
            try {
              EventPacket got = read(format, damage.bytes());
              read.add(got.size());
              if (damage.at() >= headerBytes(name, whole)) {
                EventPacket before = read(format, Arrays.copyOf(whole, damage.at()));
                // A row of text that ends too early may look like a whole one.
                int sure = name.equals("csv") ? Math.max(0, before.size() - 1) : before.size();
                assertTrue(got.size() >= sure, "case " + i + " of " + name);
                assertEquals(
                    EventPackets.part(before, 0, sure),
                    EventPackets.part(got, 0, sure),
                    "case " + i + " of " + name);
              }
            } catch (RecordingProblem problem) {
              assertTrue(
                  problem.getMessage().startsWith(folder.resolve("damaged").toString()),
                  problem.getMessage());
            }
          }
          assertTrue(read.size() > CASES / 4, read.size() + " of the files were read");
        });
  }
}
