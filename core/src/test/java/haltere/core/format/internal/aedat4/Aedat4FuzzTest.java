package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Thousands of damaged files, the same at every run: nothing but a problem in words may come of
 * them, soon, and the packets before the damage are the true ones.
 */
class Aedat4FuzzTest {
  private static final int CASES = 1_000;
  private static final int CUTS = 1_000;
  private static final int PACKETS = 8;
  private static final int EVENTS = 30;
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);

  @TempDir Path folder;

  private record True(byte[] bytes, EventPacket events, int[] packetEnds, int header) {
    /** Events in packets that end before a byte. */
    int soundEvents(int firstDamage) {
      int packets = 0;
      while (packets < PACKETS && packetEnds[packets] <= firstDamage) {
        packets++;
      }
      return firstDamage < header ? 0 : packets * EVENTS;
    }
  }

  private True file(Aedat4Compression compression) throws IOException {
    Path file = folder.resolve("true.aedat4");
    EventPacket events =
        EventPackets.uniform(SENSOR, compression.ordinal() + 1, PACKETS * EVENTS, 5_000_000, 40);
    try (Aedat4Writer writer =
        Aedat4Writer.create(file, WriteOptions.of(SENSOR).withOverwrite(true), compression)) {
      for (int i = 0; i < PACKETS; i++) {
        writer.write(EventPackets.part(events, i * EVENTS, (i + 1) * EVENTS));
        writer.writeThrough();
      }
      writer.finish();
    }
    byte[] bytes = Files.readAllBytes(file);
    ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int header = 18 + numbers.getInt(14);
    int[] ends = new int[PACKETS];
    int at = header;
    for (int i = 0; i < PACKETS; i++) {
      at += 8 + numbers.getInt(at + 4);
      ends[i] = at;
    }
    assertEquals(numbers.getLong(Aedat4Header.TABLE_POSITION_OFFSET), at);
    return new True(bytes, events, ends, header);
  }

  private static int damage(byte[] bytes, SplittableRandom random, byte[][] result) {
    int at = random.nextInt(bytes.length);
    switch (random.nextInt(4)) {
      case 0 -> {
        result[0] = bytes.clone();
        int first = bytes.length;
        for (int i = 1 + random.nextInt(8); i > 0; i--) {
          int place = random.nextInt(4) == 0 ? random.nextInt(64) : random.nextInt(bytes.length);
          result[0][place] ^= (byte) (1 << random.nextInt(8));
          first = Math.min(first, place);
        }
        return first;
      }
      case 1 -> {
        byte[] inserted = new byte[1 + random.nextInt(40)];
        random.nextBytes(inserted);
        result[0] =
            ByteBuffer.allocate(bytes.length + inserted.length)
                .put(bytes, 0, at)
                .put(inserted)
                .put(bytes, at, bytes.length - at)
                .array();
      }
      case 2 -> {
        result[0] = bytes.clone();
        int to = Math.min(bytes.length, at + 1 + random.nextInt(64));
        for (int i = at; i < to; i++) {
          result[0][i] = (byte) random.nextInt(256);
        }
      }
      default -> {
        result[0] = bytes.clone();
        int[] lies = {0, -1, 1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 24, 65_536};
        ByteBuffer.wrap(result[0])
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(Math.min(at, bytes.length - 4), lies[random.nextInt(lies.length)]);
        return Math.min(at, bytes.length - 4);
      }
    }
    return at;
  }

  private StreamRecorder read(byte[] bytes, int packetEvents, String label, boolean[] cut)
      throws IOException {
    Path file = folder.resolve("damaged.aedat4");
    ReplacedFile.write(file, bytes);
    StreamRecorder recorder = new StreamRecorder();
    ReadOptions options = ReadOptions.DEFAULT.withPacketEvents(packetEvents);
    try (RecordingReader reader = new Aedat4Format().open(file, options)) {
      reader.drainTo(new StreamGrammar(recorder));
      cut[0] = reader.violations().count(Violation.CUT_OFF) > 0;
      reader.seek(5_000_000 + 100L * packetEvents);
      StreamRecorder again = new StreamRecorder();
      reader.drainTo(new StreamGrammar(again));
      assertTrue(again.events().size() <= recorder.events().size(), label);
      return recorder;
    } catch (RecordingProblem problem) {
      assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      return null;
    } catch (RuntimeException | Error unexpected) {
      throw new AssertionError(label, unexpected);
    }
  }

  @Test
  void damagedFilesAreReadOrRejected() throws IOException {
    for (Aedat4Compression compression :
        new Aedat4Compression[] {
          Aedat4Compression.NONE, Aedat4Compression.LZ4, Aedat4Compression.ZSTD
        }) {
      True truth = file(compression);
      SplittableRandom random = new SplittableRandom(compression.ordinal());
      assertTimeout(Duration.ofSeconds(60), () -> fuzz(compression, truth, random));
    }
  }

  private void fuzz(Aedat4Compression compression, True truth, SplittableRandom random)
      throws IOException {
    byte[][] damaged = new byte[1][];
    int refused = 0;
    for (int i = 0; i < CASES; i++) {
      int first = damage(truth.bytes, random, damaged);
      String label = compression + " case " + i + ", damage at byte " + first;
      StreamRecorder got = read(damaged[0], 1 + random.nextInt(200), label, new boolean[1]);
      if (got == null) {
        refused++;
        assertTrue(first < truth.header, label);
        continue;
      }
      int sound = truth.soundEvents(first);
      assertTrue(got.events().size() >= sound, label);
      assertEquals(
          EventPackets.part(truth.events, 0, sound),
          EventPackets.part(got.events(), 0, sound),
          label);
    }
    assertTrue(refused < CASES / 2, refused + " of " + CASES + " files were refused");
  }

  @Test
  void truncatedFileYieldsItsCompletePackets() throws IOException {
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      True truth = file(compression);
      SplittableRandom random = new SplittableRandom(7);
      int length = truth.header;
      for (int i = 0; i < CUTS / 5; i++) {
        String label = compression + " cut to " + length;
        boolean[] cut = new boolean[1];
        StreamRecorder got = read(Arrays.copyOf(truth.bytes, length), 50, label, cut);
        int sound = truth.soundEvents(length);
        assertEquals(EventPackets.part(truth.events, 0, sound), got.events(), label);
        assertTrue(cut[0] || length >= truth.packetEnds[PACKETS - 1], label);
        length = random.nextInt(truth.header, truth.bytes.length);
      }
    }
  }

  @Test
  void truncatedHeaderIsRejectedWithAMessage() throws IOException {
    True truth = file(Aedat4Compression.NONE);
    for (int length = 0; length < truth.header; length++) {
      assertEquals(
          null, read(Arrays.copyOf(truth.bytes, length), 50, "cut to " + length, new boolean[1]));
    }
  }
}
