package haltere.device.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.device.protocol.WireDecoder.Stop;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Properties of the decoders of 16-bit words on arbitrary input. */
class WireDecoderTest {
  private static final DavisLayout DAVIS = new DavisLayout(346, 260, false, 0, 0, false, false);
  private static final DavisLayout TURNED = new DavisLayout(180, 240, true, 7, 7, true, true);
  private static final SensorGeometry EVK = new SensorGeometry(1280, 720, Origin.TOP);

  @Test
  void arbitraryDavisBytesGiveAscendingTimesAndNoException() {
    junk(() -> new DavisDecoder(DAVIS, true), DAVIS.geometry(), 0);
    junk(() -> new DavisDecoder(TURNED, true), TURNED.geometry(), 0);
    // Words of frames and inertial samples only, so that they meet in all orders.
    junk(() -> new DavisDecoder(TURNED, true), TURNED.geometry(), 1);
  }

  @Test
  void arbitraryEvkBytesGiveAscendingTimesAndNoException() {
    junk(() -> new Evt3WireDecoder(EVK, true), EVK, 0);
  }

  private static void junk(Supplier<WireDecoder> decoders, SensorGeometry sensor, int kind) {
    Random random = new Random(5);
    EventPacket packet = new EventPacket(16);
    for (int round = 0; round < 300; round++) {
      WireDecoder decoder = decoders.get();
      byte[] bytes = new byte[random.nextInt(3000)];
      random.nextBytes(bytes);
      for (int i = 1; kind == 1 && i < bytes.length; i += 2) {
        boolean special = random.nextBoolean();
        bytes[i] = (byte) (special ? 0 : 0x40 + random.nextInt(0x14));
        bytes[i - 1] = special ? (byte) (5 + random.nextInt(11)) : bytes[i - 1];
      }
      ByteBuffer in = ByteBuffer.wrap(bytes);
      long last = Long.MIN_VALUE;
      for (Stop stop = null; stop != Stop.INPUT_USED; ) {
        packet.clear();
        stop = decoder.decode(in, packet, 100);
        for (int i = 0; i < packet.size(); i++) {
          assertTrue(packet.timeUs(i) >= last, "time went back");
          assertTrue(sensor.contains(packet.x(i), packet.y(i)), "outside of the sensor");
          last = packet.timeUs(i);
        }
        last = stop == Stop.CLOCK_RESET ? Long.MIN_VALUE : last;
      }
    }
  }

  @Test
  void davisEventsAfterMissingBytesNeedATimeAndARowAndTheirTimeDoesNotGoBack() {
    WireDecoder decoder = new DavisDecoder(DAVIS, false);
    decodeWords(decoder, 0x7001, 0x8000 | 20_000, 0x1005, 0x3007);
    decoder.breakOffUnknown();

    EventPacket after = decodeWords(decoder, 0x1004, 0x3008, 0x8000 | 10_000, 0x1006, 0x3009);

    assertEquals(1, after.size());
    assertEquals(9, after.x(0));
    assertEquals(253, after.y(0));
    assertEquals(2 * DavisDecoder.WRAP_US + 10_000, after.timeUs(0));
  }

  @Test
  void evkEventsAfterMissingBytesNeedARow() {
    WireDecoder decoder = new Evt3WireDecoder(EVK, false);
    decodeWords(decoder, 0x8000, 0x6001, 0x0005, 0x2007);
    decoder.breakOffUnknown();

    EventPacket after = decodeWords(decoder, 0x8000, 0x2008, 0x4001, 0x0006, 0x2009);

    assertEquals(1, after.size());
    assertEquals(9, after.x(0));
    assertEquals(713, after.y(0));
  }

  @Test
  void evkEventsAfterMissingBytesNeedATime() {
    WireDecoder decoder = new Evt3WireDecoder(EVK, true);
    decodeWords(decoder, 0x8001, 0x6fff, 0x0005, 0x2007);
    decoder.breakOffUnknown();

    EventPacket after = decodeWords(decoder, 0x6001, 0x0006, 0x2008, 0x8002, 0x0007, 0x2009);

    assertEquals(1, after.size());
    assertEquals(9, after.x(0));
    assertEquals(2 << 12, after.timeUs(0));
  }

  @Test
  void davisEventsAfterAnyGapHaveTheirRowAndAscend() {
    gaps(() -> new DavisDecoder(DAVIS, false), WireDecoderTest::davisGroup, 259);
  }

  @Test
  void evkEventsAfterAnyGapHaveTheirRowAndAscend() {
    gaps(() -> new Evt3WireDecoder(EVK, false), WireDecoderTest::evkGroup, 719);
  }

  /** Words of an event in a row as far from the top as its column is from the left. */
  private interface Group {
    void add(List<Integer> words, long beforeUs, long timeUs, int place);
  }

  private static void davisGroup(List<Integer> words, long beforeUs, long timeUs, int place) {
    for (long wrap = beforeUs >> 15; wrap < timeUs >> 15; wrap++) {
      words.add(0x7001);
    }
    words.add(0x8000 | (int) timeUs & 0x7fff);
    words.add(0x1000 | place);
    words.add(0x3000 | place);
  }

  private static void evkGroup(List<Integer> words, long beforeUs, long timeUs, int place) {
    if (beforeUs >> 12 != timeUs >> 12) {
      words.add(0x8000 | (int) (timeUs >> 12) & 0xfff);
    }
    words.add(0x6000 | (int) timeUs & 0xfff);
    words.add(place);
    words.add(0x2000 | place);
  }

  private static void gaps(Supplier<WireDecoder> decoders, Group group, int top) {
    Random random = new Random(21);
    for (int round = 0; round < 500; round++) {
      List<Integer> sent = new ArrayList<>();
      long timeUs = 1L << 24;
      group.add(sent, 0, timeUs, 0);
      for (int i = 0; i < 40; i++) {
        long beforeUs = timeUs;
        timeUs += random.nextInt(random.nextBoolean() ? 100 : 50_000);
        group.add(sent, beforeUs, timeUs, random.nextInt(250));
      }
      int[] words = sent.stream().mapToInt(Integer::intValue).toArray();
      int from = random.nextInt(words.length);
      int to = from + random.nextInt(words.length - from);
      WireDecoder decoder = decoders.get();
      EventPacket events = decodeAll(decoder, bytes(words, 0, from));
      decoder.breakOffUnknown();
      EventPacket after = decodeAll(decoder, bytes(words, to, words.length));
      events.append(after, 0, after.size());

      for (int i = 0; i < events.size(); i++) {
        assertEquals(top - events.x(i), events.y(i), "row");
        assertTrue(i == 0 || events.timeUs(i) >= events.timeUs(i - 1), "time went back");
      }
      assertEquals(0, decoder.unknownWords());
    }
  }

  private static EventPacket decodeWords(WireDecoder decoder, int... words) {
    return decodeAll(decoder, bytes(words, 0, words.length));
  }

  @Test
  void droppedDavisWordsUpdateTimeAndRowLikeDecodedWords() {
    sameAfterDropping(
        () -> new DavisDecoder(DAVIS, false),
        random ->
            switch (random.nextInt(5)) {
              case 0 -> 0x7000 | random.nextInt(3);
              case 1 -> 0x1000 | random.nextInt(260);
              case 2 -> 0x8000 | random.nextInt(1 << 15);
              case 3 -> random.nextInt(10) == 0 ? 1 : 0x2000;
              default -> 0x3000 | random.nextInt(346);
            },
        new int[] {0x7001, 0x1005, 0x8005},
        new int[] {0xffff, 0x3007});
  }

  @Test
  void droppedEvkWordsUpdateTimeAndRowLikeDecodedWords() {
    int[] high = new int[1];
    sameAfterDropping(
        () -> new Evt3WireDecoder(EVK, false),
        random ->
            switch (random.nextInt(6)) {
              case 0 -> {
                high[0] = high[0] + 1 + random.nextInt(500) & 0xfff;
                yield 0x8000 | high[0];
              }
              case 1 -> random.nextInt(720);
              case 2 -> 0x3000 | random.nextInt(1200);
              case 3 -> 0x4000 | random.nextInt(4096);
              case 4 -> 0x5000 | random.nextInt(256);
              default -> 0x2000 | random.nextInt(1280);
            },
        new int[] {0x8000, 0x6001, 0x0005, 0x3004},
        new int[] {0x6fff, 0x2007, 0x4001});
  }

  private interface Words {
    int next(Random random);
  }

  private static void sameAfterDropping(
      Supplier<WireDecoder> decoders, Words words, int[] before, int[] after) {
    Random random = new Random(9);
    for (int round = 0; round < 300; round++) {
      int[] dropped = new int[random.nextInt(60)];
      WireDecoder whole = decoders.get();
      WireDecoder skipping = decoders.get();
      decodeAll(whole, bytes(before, 0, before.length));
      decodeAll(skipping, bytes(before, 0, before.length));
      for (int i = 0; i < dropped.length; i++) {
        dropped[i] = words.next(random);
      }
      whole.breakOff();
      decodeAll(whole, bytes(dropped, 0, dropped.length));
      DroppedWords note = skipping.droppedWords();
      DroppedWords later = skipping.droppedWords();
      int cut = random.nextInt(dropped.length + 1);
      note.add(bytes(dropped, 0, cut));
      later.add(bytes(dropped, cut, dropped.length));
      note.add(later);
      skipping.breakOff();
      note.replay(replayed -> decodeAll(skipping, replayed));
      whole.breakOff();
      skipping.breakOff();

      assertEquals(
          decodeAll(whole, bytes(after, 0, after.length)),
          decodeAll(skipping, bytes(after, 0, after.length)));
    }
  }

  private static EventPacket decodeAll(WireDecoder decoder, ByteBuffer in) {
    EventPacket all = new EventPacket(16);
    EventPacket packet = new EventPacket(16);
    for (Stop stop = null; stop != Stop.INPUT_USED; ) {
      packet.clear();
      stop = decoder.decode(in, packet, 1000);
      all.append(packet, 0, packet.size());
    }
    return all;
  }

  private static ByteBuffer bytes(int[] words, int from, int to) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * (to - from)).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = from; i < to; i++) {
      bytes.putShort((short) words[i]);
    }
    return bytes.flip();
  }
}
