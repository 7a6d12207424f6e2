package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Files cut, changed, lengthened and filled up at random, the same at every run: nothing but a
 * problem in words may come of them, and the events before the damage are the true ones.
 */
class DamagedFilesTest {
  private static final int CASES = 1000;
  private static final int FILES = 7;
  private static final int CUTS = 400;

  /** Bytes before the header of AEDAT-4, the last four of which are its size. */
  private static final int AEDAT4_START = 18;

  private static final Duration SOON = Duration.ofSeconds(60);
  private static final long[] LIES = {
    0, 1, -1, 500, 0x7fff, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, Long.MAX_VALUE, 1L << 40
  };

  @TempDir Path folder;

  static Set<String> formats() {
    return Recordings.formats().keySet();
  }

  /** A damaged copy, and the first byte that is not as it was. */
  private record Damage(byte[] bytes, int at) {}

  private static Damage damage(byte[] whole, SplittableRandom random) {
    int at = random.nextInt(whole.length);
    switch (random.nextInt(6)) {
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
      case 4:
        return lie(whole, at, random);
      default:
        int lost = Math.min(whole.length, at + random.nextInt(1, 30));
        return new Damage(joined(whole, at, new byte[0], lost), at);
    }
  }

  /** A number that cannot be true, of 2, 4 or 8 bytes in either order. */
  private static Damage lie(byte[] whole, int place, SplittableRandom random) {
    int size = 2 << random.nextInt(3);
    int at = Math.min(place, whole.length - size);
    long number = LIES[random.nextInt(LIES.length)];
    ByteBuffer bytes = ByteBuffer.wrap(whole.clone());
    bytes.order(random.nextBoolean() ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    switch (size) {
      case 2 -> bytes.putShort(at, (short) number);
      case 4 -> bytes.putInt(at, (int) number);
      default -> bytes.putLong(at, number);
    }
    return new Damage(bytes.array(), at);
  }

  private static byte[] joined(byte[] whole, int to, byte[] between, int from) {
    return ByteBuffer.allocate(to + between.length + whole.length - from)
        .put(whole, 0, to)
        .put(between)
        .put(whole, from, whole.length - from)
        .array();
  }

  private EventPacket read(RecordingFormat format, byte[] bytes) throws IOException {
    Path file = ReplacedFile.write(folder.resolve("damaged"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    ReadOptions options = ReadOptions.DEFAULT.withSensor(SmallFiles.sensor(format));
    try (RecordingReader reader = format.open(file, options)) {
      reader.drainTo(new StreamGrammar(recorder));
      List<TimeSegment> segments = reader.segments();
      assertEquals(recorder.events().isEmpty(), segments.isEmpty());
      for (String line : reader.violations().describe()) {
        assertTrue(line.contains("byte "), line);
      }
    }
    return recorder.events();
  }

  /**
   * Where the header ends; damage before it may make another recording of the file. NumPy, HDF5 and
   * bags, whose directories and checksums may be what is damaged, are all header.
   */
  private static int headerBytes(String name, byte[] whole) {
    String text = new String(whole, StandardCharsets.ISO_8859_1);
    return switch (name) {
      case "aedat1" -> text.indexOf("us\r\n") + 4;
      case "aedat2" -> endOfLines(text);
      case "aedat4" ->
          AEDAT4_START
              + ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN).getInt(AEDAT4_START - 4);
      case "aedat3" -> text.indexOf("END-HEADER\r\n") + 12;
      case "evt2", "evt21", "evt3" -> text.indexOf("% end\n") + 6;
      case "dat" -> text.indexOf("\n\f\b") + 3;
      case "es" -> 20;
      case "csv" -> text.indexOf('\n') + 1;
      case "nmnist" -> 0;
      default -> whole.length;
    };
  }

  private static int endOfLines(String text) {
    int end = 0;
    while (text.charAt(end) == '#') {
      end = text.indexOf("\r\n", end) + 2;
    }
    return end;
  }

  @ParameterizedTest
  @MethodSource("formats")
  void damageIsDetectedAndEarlierEventsAreRead(String name) {
    assertTimeoutPreemptively(SOON, () -> damageAndRead(Recordings.formats().get(name)));
  }

  private void damageAndRead(RecordingFormat format) throws IOException {
    String name = format.name();
    SplittableRandom random = new SplittableRandom(name.hashCode());
    List<byte[]> files = new ArrayList<>();
    for (int i = 1; i <= FILES; i++) {
      files.add(SmallFiles.bytes(format, i, folder));
    }
    int read = 0;
    for (int i = 0; i < CASES; i++) {
      byte[] whole = files.get(i % FILES);
      Damage damage = damage(whole, random);
      String what = "case " + i + " of " + name + ", damaged at byte " + damage.at();
      try {
        EventPacket got = read(format, damage.bytes());
        read++;
        if (damage.at() >= headerBytes(name, whole)) {
          EventPacket before = read(format, Arrays.copyOf(whole, damage.at()));
          // A row of text that ends too early may look like a whole one.
          int sure = name.equals("csv") ? Math.max(0, before.size() - 1) : before.size();
          assertTrue(got.size() >= sure, what);
          assertEquals(EventPackets.part(before, 0, sure), EventPackets.part(got, 0, sure), what);
        }
      } catch (RecordingProblem problem) {
        assertTrue(
            problem.getMessage().startsWith(folder.resolve("damaged").toString()),
            problem.getMessage());
      } catch (RuntimeException fault) {
        throw new AssertionError(what + ": " + fault, fault);
      }
    }
    assertTrue(read > CASES / 4, read + " of the files were read");
  }

  /** Nothing is invented, and nothing is lost that arrived whole. */
  @ParameterizedTest
  @MethodSource("formats")
  void longerTruncatedFileNeverYieldsFewerEvents(String name) {
    assertTimeoutPreemptively(SOON, () -> cutAndRead(Recordings.formats().get(name)));
  }

  private void cutAndRead(RecordingFormat format) throws IOException {
    for (int number = 1; number <= 2; number++) {
      byte[] whole = SmallFiles.bytes(format, number, folder);
      EventPacket events = read(format, whole);
      int step = Math.max(1, whole.length / CUTS);
      int before = 0;
      for (int length = 1; length < whole.length; length += step) {
        String what = format.name() + " " + number + " cut to " + length + " bytes";
        try {
          EventPacket got = read(format, Arrays.copyOf(whole, length));
          // A row of text that ends too early may look like a whole one.
          int sure = Math.max(0, format.name().equals("csv") ? got.size() - 1 : got.size());
          assertTrue(sure <= events.size(), what);
          assertEquals(EventPackets.part(events, 0, sure), EventPackets.part(got, 0, sure), what);
          assertTrue(sure >= before, what + ": " + sure + " after " + before + " events");
          before = sure;
        } catch (RecordingProblem problem) {
          assertEquals(0, before, what + ": " + problem.getMessage());
        }
      }
    }
  }
}
