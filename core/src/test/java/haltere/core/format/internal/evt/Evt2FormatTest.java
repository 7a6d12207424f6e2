package haltere.core.format.internal.evt;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.RecordingFormat;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** EVT2 keeps the contract of RAW files and matches Prophesee's specification. */
class Evt2FormatTest extends EvtContract {
  @Override
  protected RecordingFormat format() {
    return new Evt2Format();
  }

  private static ByteBuffer words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocate(words.length * 4).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putInt(word);
    }
    return bytes.flip();
  }

  private static int event(int on, int low, int x, int y) {
    return on << 28 | low << 22 | x << 11 | y;
  }

  private static int high(long timeUs) {
    return 8 << 28 | (int) (timeUs >> 6);
  }

  @Override
  byte[] fillers() {
    return words(0xe0000014, 0xf0000001, 0xa0000101, 0xd0000000, 0x70000000).array();
  }

  @Override
  byte[] randomWords(SplittableRandom random) {
    ByteBuffer bytes = ByteBuffer.allocate(20_000).order(ByteOrder.LITTLE_ENDIAN);
    int time = random.nextInt(1 << 20);
    while (bytes.hasRemaining()) {
      time += random.nextInt(100) - (random.nextInt(50) == 0 ? 1000 : 0);
      bytes.putInt(
          switch (random.nextInt(20)) {
            case 0 -> random.nextInt();
            case 1, 2, 3, 4 -> 8 << 28 | Math.max(0, time);
            default ->
                event(
                    random.nextInt(2),
                    random.nextInt(64),
                    random.nextInt(605),
                    random.nextInt(403));
          });
    }
    return bytes.array();
  }

  @Test
  void wordsAreDecodedAsSpecifiedByProphesee() {
    ViolationCounts violations = new ViolationCounts();
    Evt2Decoder decoder = new Evt2Decoder(GEN3, 0, violations);
    EventPacket packet = new EventPacket(0);
    decoder.decode(
        words(
            event(1, 0, 1, 1),
            high(640),
            event(1, 5, 3, 0),
            0xa1400101,
            event(0, 63, 639, 479),
            event(0, 63, 640, 479),
            event(0, 63, 3, 480),
            0x20000000),
        100,
        packet,
        100);

    assertEquals(2, packet.size());
    assertEquals(645, packet.timeUs(0));
    assertEquals(EventAddress.pack(3, 479, 1), packet.address(0));
    assertEquals(703, packet.timeUs(1));
    assertEquals(EventAddress.pack(639, 0, 0), packet.address(1));
    assertEquals(1, violations.count(Violation.NO_TIME_YET));
    assertEquals(100, violations.firstOffset(Violation.NO_TIME_YET));
    assertEquals(1, violations.count(Violation.OTHER_DATA));
    assertEquals(112, violations.firstOffset(Violation.OTHER_DATA));
    assertEquals(2, violations.count(Violation.OUTSIDE_SENSOR));
    assertEquals(120, violations.firstOffset(Violation.OUTSIDE_SENSOR));
    assertEquals(1, violations.count(Violation.UNKNOWN_WORD));
  }

  @Test
  void clockWrapsAfter34BitsAndRestartsOtherwise() {
    Evt2Decoder decoder = new Evt2Decoder(GEN3, 0, new ViolationCounts());
    EventPacket packet = new EventPacket(0);
    long lastUs = (1L << 34) - 64;
    ByteBuffer in =
        words(
            high(lastUs),
            event(0, 1, 0, 0),
            high(128),
            event(0, 2, 0, 0),
            high(64),
            event(0, 0, 0, 0));
    boolean back = decoder.decode(in, 0, packet, 100);

    assertEquals(true, back);
    assertEquals(2, packet.size());
    assertEquals(lastUs + 1, packet.timeUs(0));
    assertEquals((1L << 34) + 130, packet.timeUs(1));
    assertEquals((1L << 34) + 64, decoder.times().restartUs());
    decoder.times().acceptRestart();
    decoder.decode(in, 20, packet, 100);
    assertEquals((1L << 34) + 64, packet.timeUs(2));
  }
}
