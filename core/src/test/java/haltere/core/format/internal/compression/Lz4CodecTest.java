package haltere.core.format.internal.compression;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import net.jpountz.lz4.LZ4Compressor;
import net.jpountz.lz4.LZ4Factory;
import org.junit.jupiter.api.Test;

/** LZ4 blocks with and without native code, also damaged ones. */
class Lz4CodecTest {
  private static final int BYTES = 4_000;
  private static final int MARGIN = 64;
  private static final byte UNTOUCHED = 0x5A;

  private final SplittableRandom random = new SplittableRandom(15);
  private final byte[] original = new byte[BYTES];
  private final byte[] out = new byte[MARGIN + BYTES + MARGIN];

  Lz4CodecTest() {
    for (int i = 0; i < BYTES; i++) {
      original[i] = (byte) (i % 16 < 10 ? i % 16 : random.nextInt(8));
    }
  }

  @Test
  void eachCompressorsBlockDecompressesWithAndWithoutNativeCode() throws DamagedPacketException {
    for (LZ4Compressor compressor : new LZ4Compressor[] {Lz4Codec.fast(), Lz4Codec.high()}) {
      byte[] block = compressor.compress(original);
      int end = Lz4Codec.decompress(block, 0, block.length, out, MARGIN, MARGIN + BYTES);
      assertEquals(MARGIN + BYTES, end);
      assertArrayEquals(original, Arrays.copyOfRange(out, MARGIN, end));

      Arrays.fill(out, (byte) 0);
      LZ4Factory java = LZ4Factory.safeInstance();
      assertEquals(
          end, Lz4Codec.decompress(java, block, 0, block.length, out, MARGIN, MARGIN + BYTES));
      assertArrayEquals(original, Arrays.copyOfRange(out, MARGIN, end));
    }
  }

  @Test
  void checksumIsXxHashWithSeedZero() {
    byte[] bytes = new byte[] {1, 2, 'a', 'b', 'c', 3};
    assertEquals(0x32D153FF, Lz4Codec.checksum(bytes, 2, 5));
    assertEquals(0x02CC5D05, Lz4Codec.checksum(bytes, 2, 2));
  }

  @Test
  void damagedBlocksNeverExceedTheOutputBuffer() {
    byte[] sound = Lz4Codec.fast().compress(original);
    int damaged = 0;
    for (int i = 0; i < 20_000; i++) {
      byte[] block = sound.clone();
      for (int flips = 1 + random.nextInt(5); flips > 0; flips--) {
        block[random.nextInt(block.length)] = (byte) random.nextInt(256);
      }
      int from = random.nextInt(3);
      int to = random.nextInt(4) == 0 ? from + random.nextInt(block.length - from) : block.length;
      int room = random.nextInt(4) == 0 ? random.nextInt(BYTES) : BYTES;
      LZ4Factory java = i % 2 == 0 ? LZ4Factory.safeInstance() : null;
      Arrays.fill(out, UNTOUCHED);
      try {
        int end =
            java == null
                ? Lz4Codec.decompress(block, from, to, out, MARGIN, MARGIN + room)
                : Lz4Codec.decompress(java, block, from, to, out, MARGIN, MARGIN + room);
        assertTrue(end >= MARGIN && end <= MARGIN + room, "end " + end);
      } catch (DamagedPacketException e) {
        damaged++;
      }
      for (int margin = 0; margin < MARGIN; margin++) {
        assertEquals(UNTOUCHED, out[margin]);
        assertEquals(UNTOUCHED, out[MARGIN + room + margin]);
      }
    }
    assertTrue(damaged > 10_000, damaged + " of the blocks were refused");
  }
}
