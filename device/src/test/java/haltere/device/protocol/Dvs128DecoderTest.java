package haltere.device.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.aedat2.Dvs128AddressDecoder;
import haltere.device.protocol.WireDecoder.Stop;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Random;
import org.junit.jupiter.api.Test;

class Dvs128DecoderTest {
  private final Dvs128Decoder decoder = new Dvs128Decoder(true);
  private final EventPacket packet = new EventPacket(16);

  private static ByteBuffer words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocateDirect(4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putInt(word);
    }
    return bytes.flip();
  }

  private static int event(int lowUs, int address) {
    return lowUs << 16 | address;
  }

  @Test
  void addressesMatchTheAedat2Decoder() {
    Dvs128AddressDecoder aedat = new Dvs128AddressDecoder(new SensorGeometry(128, 128));
    for (int address = 0; address < 1 << 15; address++) {
      packet.clear();
      decoder.decode(words(event(1, address)), packet, 16);
      assertEquals(aedat.address(address), packet.address(0));
    }
  }

  @Test
  void wrapWordAdds16384UsWhateverItsOtherBits() {
    decoder.decode(words(event(5, 0), 0xffff_ffff, event(6, 0)), packet, 16);

    assertEquals(5, packet.timeUs(0));
    assertEquals(16_390, packet.timeUs(1));
  }

  @Test
  void resetWordStopsDecodingAndRestartsTime() {
    ByteBuffer in = words(event(500, 0), 0x4000_8000, event(6, 0));

    assertEquals(Stop.CLOCK_RESET, decoder.decode(in, packet, 16));
    assertEquals(1, packet.size());
    packet.clear();
    assertEquals(Stop.INPUT_USED, decoder.decode(in, packet, 16));
    assertEquals(6, packet.timeUs(0));
  }

  @Test
  void fullPacketStopsDecodingWithoutLoss() {
    int[] many = new int[3000];
    for (int i = 0; i < many.length; i++) {
      many[i] = event(i, 2 * i & 0x7fff);
    }
    ByteBuffer in = words(many);
    int events = 0;
    Stop stop = Stop.PACKET_FULL;
    while (stop == Stop.PACKET_FULL) {
      packet.clear();
      stop = decoder.decode(in, packet, 7);
      events += packet.size();
      assertTrue(packet.size() <= 7);
    }
    assertEquals(3000, events);
    assertEquals(2999, packet.timeUs(packet.size() - 1));
  }

  @Test
  void arbitraryBytesGiveAscendingTimesAndNoException() {
    Random random = new Random(11);
    for (int round = 0; round < 200; round++) {
      Dvs128Decoder fresh = new Dvs128Decoder(true);
      byte[] junk = new byte[random.nextInt(2000)];
      random.nextBytes(junk);
      ByteBuffer in = ByteBuffer.wrap(junk);
      long last = Long.MIN_VALUE;
      for (Stop stop = null; stop != Stop.INPUT_USED; ) {
        packet.clear();
        stop = fresh.decode(in, packet, 100);
        for (int i = 0; i < packet.size(); i++) {
          assertTrue(packet.timeUs(i) >= last);
          last = packet.timeUs(i);
        }
        last = stop == Stop.CLOCK_RESET ? Long.MIN_VALUE : last;
      }
    }
  }

  @Test
  void droppedWordsAdvanceTimeLikeDecodedWords() {
    Random random = new Random(12);
    for (int round = 0; round < 200; round++) {
      int[] dropped = new int[random.nextInt(40)];
      for (int i = 0; i < dropped.length; i++) {
        dropped[i] =
            switch (random.nextInt(4)) {
              case 0 -> 0x8000_0000;
              case 1 -> random.nextInt(20) == 0 ? 0x4000_0000 : 0x8000_0000;
              default -> event(random.nextInt(10), 2);
            };
      }
      Dvs128Decoder whole = new Dvs128Decoder(false);
      Dvs128Decoder skipping = new Dvs128Decoder(false);
      decodeAll(whole, words(0x8000_0000), new EventPacket(1));
      decodeAll(skipping, words(0x8000_0000), new EventPacket(1));
      EventPacket events = new EventPacket(1);
      decodeAll(whole, words(dropped), events);
      DroppedWords note = skipping.droppedWords();
      DroppedWords later = skipping.droppedWords();
      int cut = dropped.length / 2;
      note.add(words(java.util.Arrays.copyOf(dropped, cut)));
      later.add(words(java.util.Arrays.copyOfRange(dropped, cut, dropped.length)));
      note.add(later);
      skipping.breakOff();
      note.replay(bytes -> decodeAll(skipping, bytes, new EventPacket(1)));

      assertEquals(events.size(), note.events());
      EventPacket one = new EventPacket(1);
      EventPacket other = new EventPacket(1);
      decodeAll(whole, words(event(100, 2)), one);
      decodeAll(skipping, words(event(100, 2)), other);
      assertEquals(one, other);
    }
  }

  @Test
  void timeDoesNotGoBackAfterMissingBytesWithAWrap() {
    decoder.decode(words(event(10_000, 0)), packet, 16);
    decoder.breakOffUnknown();
    decoder.decode(words(event(9_000, 0), 0x8000_0000, event(5, 0)), packet, 16);

    assertEquals(16_384 + 9_000, packet.timeUs(1));
    assertEquals(2 * 16_384 + 5, packet.timeUs(2));
    assertEquals(0, decoder.unknownWords());
  }

  @Test
  void smallDecreaseAfterTheFirstEventOfAGapIsAnErrorOfTheCamera() {
    decoder.decode(words(event(10_000, 0)), packet, 16);
    decoder.breakOffUnknown();
    decoder.decode(words(event(10_100, 0), event(10_050, 0)), packet, 16);

    assertEquals(10_100, packet.timeUs(2));
    assertEquals(1, decoder.unknownWords());
  }

  private static void decodeAll(WireDecoder decoder, ByteBuffer in, EventPacket out) {
    while (in.hasRemaining()) {
      decoder.decode(in, out, out.size() + 5000);
    }
  }
}
