package haltere.core.format.internal.packed;

/** The 32-bit checksum of LZ4 frames, with seed 0. */
public final class XxHash32 {
  private static final int P1 = 0x9E3779B1;
  private static final int P2 = 0x85EBCA77;
  private static final int P3 = 0xC2B2AE3D;
  private static final int P4 = 0x27D4EB2F;
  private static final int P5 = 0x165667B1;

  private XxHash32() {}

  /**
   * The checksum of some bytes.
   *
   * @param bytes where
   * @param from index of the first
   * @param to index behind the last
   * @return the checksum
   */
  public static int of(byte[] bytes, int from, int to) {
    int at = from;
    int hash;
    if (to - from >= 16) {
      int a = P1 + P2;
      int b = P2;
      int c = 0;
      int d = -P1;
      for (; at <= to - 16; at += 16) {
        a = round(a, LittleEndian.getInt(bytes, at));
        b = round(b, LittleEndian.getInt(bytes, at + 4));
        c = round(c, LittleEndian.getInt(bytes, at + 8));
        d = round(d, LittleEndian.getInt(bytes, at + 12));
      }
      hash =
          Integer.rotateLeft(a, 1)
              + Integer.rotateLeft(b, 7)
              + Integer.rotateLeft(c, 12)
              + Integer.rotateLeft(d, 18);
    } else {
      hash = P5;
    }
    hash += to - from;
    for (; at <= to - 4; at += 4) {
      hash = Integer.rotateLeft(hash + LittleEndian.getInt(bytes, at) * P3, 17) * P4;
    }
    for (; at < to; at++) {
      hash = Integer.rotateLeft(hash + (bytes[at] & 0xff) * P5, 11) * P1;
    }
    hash = (hash ^ hash >>> 15) * P2;
    hash = (hash ^ hash >>> 13) * P3;
    return hash ^ hash >>> 16;
  }

  private static int round(int lane, int input) {
    return Integer.rotateLeft(lane + input * P2, 13) * P1;
  }
}
