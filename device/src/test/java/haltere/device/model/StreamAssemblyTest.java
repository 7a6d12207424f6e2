package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.event.EventPacket;
import haltere.device.protocol.DavisDecoder;
import haltere.device.protocol.DavisLayout;
import haltere.device.protocol.DroppedWords;
import haltere.device.protocol.Dvs128Decoder;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.BusWork;
import haltere.device.usb.ReceivedBuffers;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

/** The clock of a camera after dropped transfers one of which failed. */
class StreamAssemblyTest {
  private static final DavisLayout DAVIS = new DavisLayout(346, 260, false, 0, 0, false, false);

  private final EventPacket packet = new EventPacket(16);

  @Test
  void dvs128TimeDoesNotGoBackIfADroppedTransferFailed() {
    WireDecoder decoder = new Dvs128Decoder(false);
    decode(decoder, dvs128Event(10_000));
    skipWithAFailure(decoder, dvs128Event(11_000));
    decode(decoder, dvs128Event(9_000));

    assertEquals(Dvs128Decoder.WRAP_US + 9_000, packet.lastTimeUs());
  }

  @Test
  void davisTimeDoesNotGoBackIfADroppedTransferFailed() {
    WireDecoder decoder = new DavisDecoder(DAVIS, false);
    decode(decoder, words(0x8000 | 20_000, 0x1005, 0x3007));
    skipWithAFailure(decoder, words(0x8000 | 10_000, 0x1005, 0x3007));
    decode(decoder, words(0x8000 | 10_001, 0x1005, 0x3007));

    assertEquals(DavisDecoder.WRAP_US + 10_001, packet.lastTimeUs());
  }

  @Test
  void timeDoesNotGoBackIfTransfersWereDroppedAfterAFailedOne() {
    WireDecoder decoder = new Dvs128Decoder(false);
    decode(decoder, dvs128Event(10_000));
    decoder.breakOffUnknown();
    DroppedWords dropped = decoder.droppedWords();
    dropped.add(dvs128Event(8_000));
    assembly(decoder).skip(dropped);
    decode(decoder, dvs128Event(9_000));

    assertEquals(Dvs128Decoder.WRAP_US + 9_000, packet.lastTimeUs());
  }

  private static void skipWithAFailure(WireDecoder decoder, ByteBuffer bytes) {
    DroppedWords dropped = decoder.droppedWords();
    dropped.addUnknown();
    dropped.add(bytes);
    assembly(decoder).skip(dropped);
  }

  private static StreamAssembly assembly(WireDecoder decoder) {
    return new StreamAssembly(
        new ReceivedBuffers(
            1, 1, 64, WhenFull.DROP_NEWEST, decoder::droppedWords, BusWork.ELSEWHERE),
        decoder,
        () -> {},
        "dvs128:0042",
        false,
        new LatencyHistogram(),
        new ClockWatch());
  }

  private void decode(WireDecoder decoder, ByteBuffer bytes) {
    decoder.decode(bytes, packet, 16);
  }

  private static ByteBuffer dvs128Event(int timeUs) {
    return words(0, timeUs);
  }

  private static ByteBuffer words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putShort((short) word);
    }
    return bytes.flip();
  }
}
