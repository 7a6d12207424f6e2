package haltere.core.format.internal.evt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
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
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** EVT3 keeps the contract of RAW files and matches Prophesee's specification. */
class Evt3FormatTest extends EvtContract {
  @Override
  protected RecordingFormat format() {
    return new Evt3Format();
  }

  private static ByteBuffer words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocate(words.length * 2).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putShort((short) word);
    }
    return bytes.flip();
  }

  private static List<Integer> columns(EventPacket packet) {
    return java.util.stream.IntStream.range(0, packet.size()).map(packet::x).boxed().toList();
  }

  @Override
  byte[] fillers() {
    return words(0xe014, 0xf000, 0xf000, 0x7000, 0xa101, 0x9000, 0x1000, 0x2005).array();
  }

  @Override
  byte[] randomWords(SplittableRandom random) {
    ByteBuffer bytes = ByteBuffer.allocate(20_000).order(ByteOrder.LITTLE_ENDIAN);
    int time = random.nextInt(1 << 24);
    while (bytes.remaining() > 6) {
      time += random.nextInt(500) - (random.nextInt(100) == 0 ? 100_000 : 0);
      switch (random.nextInt(10)) {
        case 0 -> bytes.putShort((short) random.nextInt());
        case 1 -> bytes.putShort((short) (0x8000 | time >> 12 & 0xfff));
        case 2, 3 -> bytes.putShort((short) (0x6000 | time & 0xfff));
        case 4, 5 -> bytes.putShort((short) random.nextInt(403));
        case 6 -> {
          bytes.putShort((short) (0x3000 | random.nextInt(2) << 11 | random.nextInt(605)));
          bytes.putShort((short) (0x4000 | random.nextInt(4096)));
          bytes.putShort((short) (0x5000 | random.nextInt(256)));
        }
        default -> bytes.putShort((short) (0x2000 | random.nextInt(2) << 11 | random.nextInt(605)));
      }
    }
    return bytes.array();
  }

  @Test
  void wordsAreDecodedAsSpecifiedByProphesee() {
    ViolationCounts violations = new ViolationCounts();
    Evt3Decoder decoder = new Evt3Decoder(GEN3, 0, violations);
    EventPacket packet = new EventPacket(0);
    decoder.decode(
        words(
            0x2005,
            0x0003,
            0x2005,
            0x8001,
            0x2006,
            0x6010,
            0x2807,
            0x8001,
            0x2008,
            0x8002,
            0x2009,
            0x0800 | 479,
            0x227f,
            0x2280,
            0x01e0,
            0x2001,
            0x1003,
            0x2001,
            0x0000,
            0xe014,
            0xf001,
            0xf000,
            0x7000,
            0xa100,
            0xb000,
            0x2002),
        0,
        packet,
        100);

    assertEquals(List.of(6, 7, 8, 9, 639, 2), columns(packet));
    assertEquals(4096, packet.timeUs(0), "a new high part has a low part of 0");
    assertEquals(4096 + 16, packet.timeUs(1));
    assertEquals(4096 + 16, packet.timeUs(2), "the same high part again changes nothing");
    assertEquals(8192, packet.timeUs(3));
    assertTrue(packet.isOn(1));
    assertEquals(476, packet.y(0));
    assertEquals(0, packet.y(4), "the bit of the other camera is no row");
    assertEquals(479, packet.y(5));
    assertEquals(2, violations.count(Violation.NO_TIME_YET));
    assertEquals(2, violations.count(Violation.OUTSIDE_SENSOR));
    assertEquals(7, violations.count(Violation.OTHER_DATA));
    assertEquals(1, violations.count(Violation.UNKNOWN_WORD));
  }

  @Test
  void vectorWordsMayBeSingleGroupedOrTruncated() {
    int[] words = {
      0x8000, 0x6005, 0x0000, 0x3800 | 32, 0x4801, 0x4003, 0x5081, 0x4fff, 0x5000, 0x4001
    };
    List<Integer> expected =
        List.of(32, 43, 44, 45, 56, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 84);
    for (int cut = 0; cut <= words.length; cut++) {
      for (int maxEvents : new int[] {1, 3, 100}) {
        Evt3Decoder decoder = new Evt3Decoder(GEN3, 0, new ViolationCounts());
        EventPacket all = new EventPacket(0);
        ByteBuffer in = words(words);
        for (int limit : new int[] {cut * 2, words.length * 2}) {
          in.limit(limit);
          int before;
          do {
            before = in.position();
            EventPacket packet = new EventPacket(0);
            decoder.decode(in, in.position(), packet, maxEvents);
            assertTrue(packet.size() <= maxEvents);
            before = packet.isEmpty() ? -1 : before;
            all.append(packet, 0, packet.size());
          } while (before >= 0);
        }
        assertEquals(expected, columns(all), "cut at word " + cut + ", packets of " + maxEvents);
        assertTrue(all.isOn(0));
      }
    }
  }

  /** Words in the sequences in which a camera sends them, and some that no camera sends. */
  private static ByteBuffer sequences(SplittableRandom random, SensorGeometry sensor) {
    ByteBuffer words = ByteBuffer.allocate(40_000).order(ByteOrder.LITTLE_ENDIAN);
    int timeUs = random.nextInt(1 << 24);
    while (words.remaining() > 40) {
      timeUs += random.nextInt(40);
      int high = 0x8000 | timeUs >>> 12 & 0xfff;
      int low = 0x6000 | (random.nextInt(300) == 0 ? random.nextInt(4096) : timeUs & 0xfff);
      int on = random.nextInt(2) << 11;
      int row = random.nextInt(random.nextInt(50) == 0 ? 2048 : Math.min(2048, sensor.height()));
      int column = random.nextInt(random.nextInt(50) == 0 ? 2048 : Math.min(2048, sensor.width()));
      for (int repeated = random.nextInt(7); repeated > 3; repeated--) {
        words.putShort((short) high);
      }
      int[] sequence =
          switch (random.nextInt(8)) {
            case 0, 1, 2 -> new int[] {low, row, 0x2000 | on | column};
            case 3 -> new int[] {row, 0x2000 | on | column};
            case 4 -> new int[] {0x2000 | on | column};
            case 5 ->
                new int[] {
                  low,
                  row,
                  0x3000 | on | column,
                  0x4000 | random.nextInt(4096),
                  0x4000 | random.nextInt(4096),
                  0x5000 | random.nextInt(256)
                };
            case 6 -> new int[] {0xe014, 0xf001, 0xf000, 0x7000, 0xe016, 0xf001, 0xf000, 0x7000};
            default -> new int[] {high, random.nextInt(20) == 0 ? random.nextInt(65536) : low};
          };
      for (int word : sequence) {
        words.putShort((short) word);
      }
    }
    return words.flip();
  }

  private static EventPacket decoded(
      ByteBuffer words, SensorGeometry sensor, int atOnceBytes, ViolationCounts violations) {
    Evt3Decoder decoder = new Evt3Decoder(sensor, 0, violations);
    EventPacket all = new EventPacket(0);
    words.position(0);
    int last = words.limit();
    while (words.position() < last) {
      words.limit(Math.min(last, words.position() + atOnceBytes));
      EventPacket packet = new EventPacket(0);
      if (decoder.decode(words, words.position(), packet, 50)) {
        decoder.times().acceptRestart();
      }
      all.append(packet, 0, packet.size());
      words.limit(last);
    }
    return all;
  }

  @Test
  void wordsDecodeEquallyInBlocksAndOneByOne() {
    List<SensorGeometry> sensors =
        List.of(GEN3, GEN4, new SensorGeometry(100, 30), new SensorGeometry(3000, 4000));
    SplittableRandom random = new SplittableRandom(6);
    for (int i = 0; i < 80; i++) {
      SensorGeometry sensor = sensors.get(i % sensors.size());
      ByteBuffer words = sequences(random, sensor);
      ViolationCounts together = new ViolationCounts();
      ViolationCounts oneByOne = new ViolationCounts();

      EventPacket all = decoded(words, sensor, 1 << 16, together);

      assertEquals(decoded(words, sensor, 2, oneByOne), all, "stream " + i);
      assertEquals(oneByOne.describe(), together.describe(), "stream " + i);
      assertTrue(all.size() > 5_000, all.size() + " events");
    }
  }

  @Test
  void clockWrapsIfItsHighPartFallsByHalf() {
    Evt3Decoder decoder = new Evt3Decoder(GEN3, 0, new ViolationCounts());
    EventPacket packet = new EventPacket(0);
    ByteBuffer in =
        words(
            0x8fff, 0x6fff, 0x0000, 0x2000, 0x8000, 0x6001, 0x2000, 0x8800, 0x2000, 0x8001, 0x2000);
    boolean back = decoder.decode(in, 0, packet, 100);

    assertEquals(true, back);
    assertEquals(3, packet.size());
    assertEquals((1L << 24) - 1, packet.timeUs(0));
    assertEquals((1L << 24) + 1, packet.timeUs(1));
    assertEquals((1L << 24) + (0x800L << 12), packet.timeUs(2));
    assertEquals((1L << 24) + 4096, decoder.times().restartUs(), "a fall by 2047 is no wrap");
  }

  @Test
  void neighbouringEventsAreWrittenAsVectors() throws IOException {
    EventPacket written = new EventPacket(0);
    for (int x = 0; x < 640; x++) {
      written.append(7, x, 9, true);
    }
    Path file = folder.resolve("row.raw");
    write(file, GEN3, written);
    byte[] bytes = Files.readAllBytes(file);
    int data = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("% end\n") + 6;

    assertEquals((20 * 4 + 3) * 2, bytes.length - data);
    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }

  @Test
  void movingBarsAreReadBack() throws IOException {
    EventPacket written = EventPackets.movingBars(GEN4, 1, 300_000, 123);
    for (int i = 0; i < written.size(); i++) {
      // Many events at the same time, as dense recordings have them.
      written.timesUs()[i] &= -64L;
    }
    Path file = folder.resolve("bars.raw");
    write(file, GEN4, written);
    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }

  @Test
  void rawFilesAreWrittenAsEvt3() throws IOException {
    assertEquals("evt3", Recordings.forWriting(Path.of("a.raw")).name());
  }
}
