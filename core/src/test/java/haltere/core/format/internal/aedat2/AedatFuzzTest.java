package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Ten thousand damaged files, the same at every run: nothing but a problem in words may come of
 * them, soon, and the events before the damage are the true ones.
 */
class AedatFuzzTest {
  private static final int CASES = 5_000;
  private static final int EVENTS = 150;
  private static final SensorGeometry DVS128 = new SensorGeometry(128, 128);
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260);

  @TempDir Path folder;

  private byte[] aedat2(SensorGeometry sensor, long seed) throws IOException {
    Path file = folder.resolve("true-" + seed + ".aedat");
    try (RecordingWriter writer =
        new Aedat2Format().create(file, WriteOptions.of(sensor)).orElseThrow()) {
      writer.write(events(sensor, seed));
      writer.finish();
    }
    return Files.readAllBytes(file);
  }

  private static EventPacket events(SensorGeometry sensor, long seed) {
    return EventPackets.uniform(sensor, seed, EVENTS, 1_000_000 * seed, 40);
  }

  /** The first changed byte is the last number of the answer. */
  private static int damage(byte[] bytes, SplittableRandom random, byte[][] result) {
    int kind = random.nextInt(4);
    int at = random.nextInt(bytes.length);
    switch (kind) {
      case 0 -> result[0] = Arrays.copyOf(bytes, at);
      case 1 -> {
        result[0] = bytes.clone();
        int flips = 1 + random.nextInt(8);
        int first = bytes.length;
        for (int i = 0; i < flips; i++) {
          int place = random.nextInt(bytes.length);
          result[0][place] ^= (byte) (1 << random.nextInt(8));
          first = Math.min(first, place);
        }
        at = first;
      }
      case 2 -> {
        byte[] inserted = new byte[1 + random.nextInt(40)];
        for (int i = 0; i < inserted.length; i++) {
          inserted[i] = (byte) (random.nextInt(4) == 0 ? '#' : random.nextInt(256));
        }
        result[0] =
            ByteBuffer.allocate(bytes.length + inserted.length)
                .put(bytes, 0, at)
                .put(inserted)
                .put(bytes, at, bytes.length - at)
                .array();
      }
      default -> {
        result[0] = bytes.clone();
        int to = Math.min(bytes.length, at + 1 + random.nextInt(64));
        for (int i = at; i < to; i++) {
          result[0][i] = (byte) random.nextInt(256);
        }
      }
    }
    return at;
  }

  private void fuzz(
      RecordingFormat format, byte[][] files, SensorGeometry[] sensors, int recordBytes, long seed)
      throws IOException {
    SplittableRandom random = new SplittableRandom(seed);
    byte[][] damaged = new byte[1][];
    Path file = folder.resolve("damaged.aedat");
    int delivered = 0;
    EventPacket[] truths = new EventPacket[files.length];
    Arrays.setAll(truths, which -> events(sensors[which], which + 1));
    for (int i = 0; i < CASES; i++) {
      int which = random.nextInt(files.length);
      byte[] whole = files[which];
      int firstDamage = damage(whole, random, damaged);
      ReplacedFile.write(file, damaged[0]);
      String label = format.name() + " case " + i + ", damage at byte " + firstDamage;
      int header = whole.length - EVENTS * recordBytes;
      int sound = Math.max(0, (firstDamage - header) / recordBytes);
      StreamRecorder recorder = new StreamRecorder();
      ReadOptions options = ReadOptions.DEFAULT.withPacketEvents(1 + random.nextInt(200));
      try (RecordingReader reader = format.open(file, options)) {
        reader.drainTo(new StreamGrammar(recorder));
        int records = damaged[0].length / recordBytes;
        assertTrue(recorder.events().size() <= records, label);
        assertTrue(reader.segments().size() <= records, label);
        reader.seek(random.nextLong());
        StreamRecorder again = new StreamRecorder();
        reader.drainTo(new StreamGrammar(again));
        assertTrue(again.events().size() <= recorder.events().size(), label);
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
        assertTrue(firstDamage < header, label + ": " + problem.getMessage());
      } catch (RuntimeException | Error unexpected) {
        throw new AssertionError(label, unexpected);
      }
      if (firstDamage >= header) {
        EventPacket truth = truths[which];
        assertTrue(recorder.events().size() >= sound, label);
        assertEquals(
            EventPackets.part(truth, 0, sound),
            EventPackets.part(recorder.events(), 0, sound),
            label);
        delivered += sound;
      }
    }
    assertTrue(delivered > CASES * EVENTS / 10, "hardly any events before the damage");
  }

  @Test
  void damagedFilesOfVersion2AreReadOrRejected() {
    assertTimeout(
        Duration.ofSeconds(120),
        () -> {
          byte[][] files = {aedat2(DVS128, 1), aedat2(DAVIS346, 2), bareAedat2(3)};
          SensorGeometry[] sensors = {DVS128, DAVIS346, DVS128};
          fuzz(new Aedat2Format(), files, sensors, RecordDecoder.AEDAT2_BYTES, 42);
        });
  }

  /** Header of the oldest files: no camera and no end line. */
  private static byte[] bareAedat2(long seed) {
    AedatFile bytes = AedatFile.version2().text("# Timestamps tick is 1 us\r\n");
    EventPacket events = events(DVS128, seed);
    for (int i = 0; i < events.size(); i++) {
      bytes.dvs128((int) events.timeUs(i), events.x(i), events.y(i), events.isOn(i));
    }
    return bytes.toBytes();
  }

  @Test
  void damagedFilesOfVersion1AreReadOrRejected() {
    assertTimeout(
        Duration.ofSeconds(120),
        () -> {
          byte[][] files = {
            AedatFile.version1().text("# a line\r\n").narrow(events(DVS128, 1)).toBytes(),
            AedatFile.version1().text("#End Of ASCII Header\n").narrow(events(DVS128, 2)).toBytes(),
            AedatFile.empty().narrow(events(DVS128, 3)).toBytes()
          };
          SensorGeometry[] sensors = {DVS128, DVS128, DVS128};
          fuzz(new Aedat1Format(), files, sensors, RecordDecoder.AEDAT1_BYTES, 43);
        });
  }
}
