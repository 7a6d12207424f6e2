package haltere.core.format.internal.evt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** EVT2.1 keeps the contract of RAW files, in both layouts of its words. */
class Evt21FormatTest extends EvtContract {
  @Override
  protected RecordingFormat format() {
    return new Evt21Format();
  }

  private static ByteBuffer words(long... words) {
    ByteBuffer bytes = ByteBuffer.allocate(words.length * 8).order(ByteOrder.LITTLE_ENDIAN);
    for (long word : words) {
      bytes.putLong(word);
    }
    return bytes.flip();
  }

  private static long vector(int on, int low, int x, int y, int mask) {
    return (long) on << 60
        | (long) low << 54
        | (long) x << 43
        | (long) y << 32
        | mask & 0xffffffffL;
  }

  private static long high(long timeUs) {
    return 8L << 60 | timeUs >> 6 << 32;
  }

  @Override
  byte[] fillers() {
    return words(0xe000001400000000L, 0xa000010100000000L, 0x3000000000000000L).array();
  }

  @Override
  byte[] randomWords(SplittableRandom random) {
    ByteBuffer bytes = ByteBuffer.allocate(20_000).order(ByteOrder.LITTLE_ENDIAN);
    long time = random.nextInt(1 << 20);
    while (bytes.hasRemaining()) {
      time += random.nextInt(100) - (random.nextInt(50) == 0 ? 1000 : 0);
      bytes.putLong(
          switch (random.nextInt(20)) {
            case 0 -> random.nextLong();
            case 1, 2, 3, 4 -> 8L << 60 | Math.max(0, time) << 32;
            default ->
                vector(
                    random.nextInt(2),
                    random.nextInt(64),
                    random.nextInt(605),
                    random.nextInt(403),
                    random.nextInt() & random.nextInt());
          });
    }
    return bytes.array();
  }

  @Test
  void wordsAreDecodedAsSpecifiedByProphesee() {
    ViolationCounts violations = new ViolationCounts();
    Evt21Decoder decoder = new Evt21Decoder(GEN3, 0, false, violations);
    EventPacket packet = new EventPacket(0);
    decoder.decode(
        words(
            vector(1, 0, 0, 0, 7),
            high(640),
            vector(1, 5, 32, 0, 0x80000001),
            vector(0, 6, 636, 479, 0x1f),
            vector(0, 6, 636, 480, 3),
            0xa000010100000000L),
        0,
        packet,
        100);

    assertEquals(6, packet.size());
    assertEquals(645, packet.timeUs(1));
    assertEquals(EventAddress.pack(32, 479, 1), packet.address(0));
    assertEquals(EventAddress.pack(63, 479, 1), packet.address(1));
    assertEquals(EventAddress.pack(639, 0, 0), packet.address(5));
    assertEquals(3, violations.count(Violation.NO_TIME_YET));
    assertEquals(3, violations.count(Violation.OUTSIDE_SENSOR));
    assertEquals(1, violations.count(Violation.OTHER_DATA));
  }

  @Test
  void swappedHalvesAreReadWithAndWithoutAHeaderEntry() throws IOException {
    EventPacket written = EventPackets.uniform(GEN3, 5, 5000, 0, 20);
    Path file = folder.resolve("legacy.raw");
    write(file, GEN3, written);
    byte[] bytes = Files.readAllBytes(file);
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int data = text.indexOf("% end\n") + 6;
    ByteBuffer words = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = data; i < bytes.length; i += 8) {
      words.putLong(i, Long.rotateLeft(words.getLong(i), 32));
    }
    String swapped = new String(bytes, StandardCharsets.ISO_8859_1);
    for (String line : new String[] {"% endianness legacy\n", ""}) {
      Files.writeString(
          file, swapped.replace("% endianness little\n", line), StandardCharsets.ISO_8859_1);
      assertEquals(written, events(file, ReadOptions.DEFAULT), line);
    }
    try (RecordingReader reader = Recordings.open(file)) {
      assertTrue(reader.remarks().get(0).contains("swapped"), reader.remarks().toString());
    }
  }

  @Test
  void neighbouringEventsShareAWord() throws IOException {
    EventPacket written = new EventPacket(0);
    for (int x = 0; x < 640; x++) {
      written.append(7, x, 9, true);
    }
    Path file = folder.resolve("row.raw");
    write(file, GEN3, written);
    byte[] bytes = Files.readAllBytes(file);
    int data = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("% end\n") + 6;

    assertEquals((20 + 1) * 8, bytes.length - data);
    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }
}
