package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.DamagedPacketException;

/** Decompresses h5py's LZF filter, and BloscLZ, which is of the same family. */
final class LzfBlock {
  private static final int BLOSC_NEAR = 8191;

  private LzfBlock() {}

  /** Decompresses LZF; returns the end of the bytes. */
  static int unpack(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    int at = from;
    int done = outFrom;
    while (at < to) {
      int control = in[at++] & 0xff;
      if (control < 32) {
        int count = control + 1;
        check(count <= to - at && count <= outTo - done);
        System.arraycopy(in, at, out, done, count);
        at += count;
        done += count;
        continue;
      }
      int count = control >> 5;
      if (count == 7) {
        check(at < to);
        count += in[at++] & 0xff;
      }
      check(at < to);
      int back = ((control & 31) << 8 | in[at++] & 0xff) + 1;
      done = repeat(out, done, outFrom, outTo, back, count + 2);
    }
    return done;
  }

  /** Decompresses BloscLZ; returns the end of the bytes. */
  static int unpackBlosc(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    int at = from;
    int done = outFrom;
    boolean first = true;
    while (at < to) {
      int control = in[at++] & 0xff;
      if (first) {
        control &= 31;
        first = false;
      }
      if (control < 32) {
        int count = control + 1;
        check(count <= to - at && count <= outTo - done);
        System.arraycopy(in, at, out, done, count);
        at += count;
        done += count;
        continue;
      }
      int count = control >> 5;
      int back = (control & 31) << 8;
      if (count == 7) {
        int more;
        do {
          check(at < to && count < outTo);
          more = in[at++] & 0xff;
          count += more;
        } while (more == 255);
      }
      check(at < to);
      int low = in[at++] & 0xff;
      if (low == 255 && back == 31 << 8) {
        check(to - at >= 2);
        back = ((in[at] & 0xff) << 8 | in[at + 1] & 0xff) + BLOSC_NEAR;
        at += 2;
      } else {
        back += low;
      }
      done = repeat(out, done, outFrom, outTo, back + 1, count + 2);
    }
    return done;
  }

  private static int repeat(byte[] out, int done, int start, int end, int back, int count)
      throws DamagedPacketException {
    check(back <= done - start && count <= end - done);
    if (back >= count) {
      System.arraycopy(out, done - back, out, done, count);
    } else if (back == 1) {
      java.util.Arrays.fill(out, done, done + count, out[done - 1]);
    } else {
      for (int i = done; i < done + count; i++) {
        out[i] = out[i - back];
      }
    }
    return done + count;
  }

  private static void check(boolean possible) throws DamagedPacketException {
    if (!possible) {
      throw new DamagedPacketException("a chunk that contradicts its compression");
    }
  }
}
