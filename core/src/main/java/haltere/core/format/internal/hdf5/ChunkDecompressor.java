package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Lz4Codec;
import haltere.core.format.internal.compression.ZstdBlock;
import java.io.Closeable;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Undoes the filters of chunks. All datasets of a file share one, and its memory.
 *
 * <p>Thread rule: one thread.
 */
final class ChunkDecompressor implements Closeable {
  private static final int CHECKSUM = 4;

  private final BloscBlock blosc = new BloscBlock(this);

  /** created on demand */
  private Inflater inflater;

  private ZstdBlock zstd;
  private byte[] one = {};
  private byte[] other = {};

  /**
   * Undoes the filters of a chunk.
   *
   * @param steps in the order in which they were applied
   * @param skipped bit mask of those not applied
   * @param in the compressed chunk at its start
   * @param length compressed bytes
   * @param out receives the chunk at its start
   * @param wanted bytes of a whole chunk
   * @return its number of bytes: fewer than wanted in the last chunk of events in ECF
   * @throws DamagedPacketException if it contradicts its compression
   */
  int unpack(List<FilterStep> steps, long skipped, byte[] in, int length, byte[] out, int wanted)
      throws DamagedPacketException {
    byte[] from = in;
    int bytes = length;
    int maxBytes = wanted + CHECKSUM * steps.size();
    int last = 0;
    while (last < steps.size() && isSkipped(skipped, last)) {
      last++;
    }
    for (int i = steps.size() - 1; i >= last; i--) {
      if (isSkipped(skipped, i)) {
        continue;
      }
      if (steps.get(i).number() == FilterStep.FLETCHER32) {
        bytes = withoutChecksum(from, bytes);
        continue;
      }
      byte[] to = i == last ? out : from == one ? other(maxBytes) : one(maxBytes);
      bytes = undo(steps.get(i), from, bytes, to, i == last ? wanted : maxBytes);
      from = to;
    }
    boolean mayBeShort = last < steps.size() && steps.get(last).number() == FilterStep.ECF;
    if (bytes > wanted || bytes < wanted && !mayBeShort) {
      throw new DamagedPacketException("a chunk of " + bytes + " bytes instead of " + wanted);
    }
    if (from != out) {
      System.arraycopy(from, 0, out, 0, bytes);
    }
    return bytes;
  }

  private static boolean isSkipped(long skipped, int step) {
    return (skipped >>> step & 1) != 0;
  }

  private byte[] one(int bytes) {
    if (one.length < bytes) {
      one = new byte[bytes];
    }
    return one;
  }

  private byte[] other(int bytes) {
    if (other.length < bytes) {
      other = new byte[bytes];
    }
    return other;
  }

  private int undo(FilterStep step, byte[] in, int length, byte[] out, int maxBytes)
      throws DamagedPacketException {
    return switch (step.number()) {
      case FilterStep.DEFLATE -> inflate(in, 0, length, out, 0, maxBytes);
      case FilterStep.SHUFFLE -> {
        if (length > maxBytes) {
          throw new DamagedPacketException("a chunk that is too large");
        }
        ByteShuffle.undo(in, 0, out, 0, length, Math.max(1, step.value(0, 1)));
        yield length;
      }
      case FilterStep.LZF -> LzfBlock.unpack(in, 0, length, out, 0, maxBytes);
      case FilterStep.BLOSC -> blosc.unpack(in, length, out, maxBytes);
      case FilterStep.LZ4 -> lz4(in, length, out, maxBytes);
      case FilterStep.ZSTD -> zstd(in, 0, length, out, 0, maxBytes);
      case FilterStep.ECF -> EcfBlock.unpack(in, length, out, maxBytes);
      default -> throw new DamagedPacketException("filter " + step.number());
    };
  }

  /** Decompresses a Zstandard frame; returns the end of the bytes. */
  int zstd(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    if (zstd == null) {
      zstd = new ZstdBlock();
    }
    return zstd.unpack(in, from, to, out, outFrom, outTo);
  }

  /** Decompresses a zlib stream; returns the end of the bytes. */
  int inflate(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    if (inflater == null) {
      inflater = new Inflater();
    }
    try {
      inflater.reset();
      inflater.setInput(in, from, to - from);
      int done = outFrom;
      while (!inflater.finished()) {
        int count = inflater.inflate(out, done, outTo - done);
        done += count;
        if (count == 0 && !inflater.finished()) {
          throw new DamagedPacketException("a chunk that does not end, or is too large");
        }
      }
      return done;
    } catch (DataFormatException e) {
      throw new DamagedPacketException(String.valueOf(e.getMessage()));
    }
  }

  /** HDF5's LZ4 filter: the whole size, that of a block, then blocks; numbers are big-endian. */
  private static int lz4(byte[] in, int length, byte[] out, int maxBytes)
      throws DamagedPacketException {
    if (length < 12) {
      throw new DamagedPacketException("a chunk that ends too early");
    }
    ByteBuffer numbers = ByteBuffer.wrap(in, 0, length);
    long whole = numbers.getLong(0);
    int blockBytes = numbers.getInt(8);
    if (whole < 0 || whole > maxBytes || blockBytes < 1) {
      throw new DamagedPacketException("a chunk that claims " + whole + " bytes");
    }
    int at = 12;
    int done = 0;
    while (done < whole) {
      int count = (int) Math.min(blockBytes, whole - done);
      int compressed = length - at < 4 ? -1 : numbers.getInt(at);
      at += 4;
      if (compressed < 0 || compressed > length - at) {
        throw new DamagedPacketException("a chunk that ends too early");
      }
      if (compressed == count) {
        System.arraycopy(in, at, out, done, count);
      } else if (Lz4Codec.decompress(in, at, at + compressed, out, done, done + count)
          != done + count) {
        throw new DamagedPacketException("a block that ends too early");
      }
      at += compressed;
      done += count;
    }
    return done;
  }

  private static int withoutChecksum(byte[] bytes, int length) throws DamagedPacketException {
    int end = length - CHECKSUM;
    if (end < 0) {
      throw new DamagedPacketException("a chunk that ends too early");
    }
    long first = 0;
    long second = 0;
    for (int i = 0; i < end; i += 2) {
      int low = i + 1 < end ? bytes[i + 1] & 0xff : 0;
      first += (bytes[i] & 0xff) << 8 | low;
      second += first;
      if ((i & 0xfffe) == 0xfffe) {
        first %= 65535;
        second %= 65535;
      }
    }
    int stored = LittleEndian.getInt(bytes, end);
    if (!same(first, stored & 0xffff) || !same(second, stored >>> 16)) {
      throw new DamagedPacketException("a chunk whose checksum is wrong");
    }
    return end;
  }

  private static boolean same(long sum, int stored) {
    return sum % 65535 == stored % 65535;
  }

  @Override
  public void close() {
    if (inflater != null) {
      inflater.end();
    }
    if (zstd != null) {
      zstd.close();
    }
  }
}
