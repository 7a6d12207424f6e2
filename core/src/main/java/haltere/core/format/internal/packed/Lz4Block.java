package haltere.core.format.internal.packed;

import java.lang.invoke.VarHandle;

/**
 * Unpacks LZ4 blocks, with the bytes before them as their dictionary, which libraries for the JVM
 * do not do for the dependent blocks that DV writes. Bytes behind the output may be overwritten, up
 * to {@link #SLACK}.
 */
public final class Lz4Block {
  /** Bytes that an output array must have behind the largest block. */
  public static final int SLACK = 64;

  private Lz4Block() {}

  /**
   * Unpacks a block.
   *
   * @param in holds the block
   * @param from its start
   * @param to its end
   * @param out receives the bytes
   * @param outFrom where
   * @param outTo where they must end at the latest; the array goes on for {@link #SLACK} bytes
   * @param dictionary where the bytes start to which matches may refer
   * @return end of the bytes
   * @throws DamagedPacketException if the block is none
   */
  public static int unpack(
      byte[] in, int from, int to, byte[] out, int outFrom, int outTo, int dictionary)
      throws DamagedPacketException {
    VarHandle longs = LittleEndian.LONG;
    VarHandle shorts = LittleEndian.SHORT;
    int safeIn = Math.min(to, in.length - 16) - 18;
    int safeOut = outTo - 34;
    int at = from;
    int done = outFrom;
    while (at < to) {
      int token = in[at++] & 0xff;
      int literals = token >>> 4;
      int match = (token & 15) + 4;
      if (literals < 15 && at <= safeIn && done <= safeOut) {
        longs.set(out, done, (long) longs.get(in, at));
        longs.set(out, done + 8, (long) longs.get(in, at + 8));
        at += literals;
        done += literals;
        int offset = (short) shorts.get(in, at) & 0xffff;
        if (match < 19 && offset >= 8 && offset <= done - dictionary) {
          at += 2;
          int source = done - offset;
          longs.set(out, done, (long) longs.get(out, source));
          longs.set(out, done + 8, (long) longs.get(out, source + 8));
          longs.set(out, done + 16, (long) longs.get(out, source + 16));
          done += match;
          continue;
        }
      } else {
        if (literals == 15) {
          int more;
          do {
            if (at >= to) {
              throw new DamagedPacketException("a length without an end");
            }
            more = in[at++] & 0xff;
            literals += more;
          } while (more == 255 && literals >= 0);
        }
        if (literals < 0 || literals > to - at || literals > outTo - done) {
          throw new DamagedPacketException("more bytes than a block holds");
        }
        System.arraycopy(in, at, out, done, literals);
        at += literals;
        done += literals;
        if (at == to) {
          return done;
        }
      }
      if (to - at < 2) {
        throw new DamagedPacketException("a block that ends too early");
      }
      int offset = (in[at] & 0xff) | (in[at + 1] & 0xff) << 8;
      at += 2;
      if (match == 19) {
        int more;
        do {
          if (at >= to) {
            throw new DamagedPacketException("a length without an end");
          }
          more = in[at++] & 0xff;
          match += more;
        } while (more == 255 && match >= 0);
      }
      if (offset == 0 || offset > done - dictionary || match < 0 || match > outTo - done) {
        throw new DamagedPacketException("a reference outside of the data");
      }
      int source = done - offset;
      int end = done + match;
      if (offset >= 8) {
        for (; done < end; done += 8, source += 8) {
          longs.set(out, done, (long) longs.get(out, source));
        }
      } else {
        while (done < end) {
          out[done++] = out[source++];
        }
      }
      done = end;
    }
    throw new DamagedPacketException("a block that ends too early");
  }
}
