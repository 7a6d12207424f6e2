package haltere.core.format.internal.npz;

import haltere.core.format.RecordingFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * The bytes of an array: stored, with random access, or compressed, in which going back means to
 * restart.
 *
 * <p>Thread rule: one thread.
 */
final class ArrayBytes {
  private static final int PIECE = 64 * 1024;

  private final RecordingFile file;
  private final long start;
  private final long compressedBytes;
  private final Inflater inflater;
  private final ByteBuffer piece = ByteBuffer.allocate(PIECE).limit(0);
  private long compressedAt;
  private long at;

  /** Uncompressed bytes in a file. */
  static ArrayBytes stored(RecordingFile file, long start, long bytes) {
    return new ArrayBytes(file, start, bytes, null);
  }

  /** Deflated bytes in a file. */
  static ArrayBytes deflated(RecordingFile file, long start, long compressedBytes) {
    return new ArrayBytes(file, start, compressedBytes, new Inflater(true));
  }

  private ArrayBytes(RecordingFile file, long start, long compressedBytes, Inflater inflater) {
    this.file = file;
    this.start = start;
    this.compressedBytes = compressedBytes;
    this.inflater = inflater;
  }

  boolean isDeflated() {
    return inflater != null;
  }

  /** Reads from an offset on; returns the number of bytes. */
  int read(long offset, byte[] target, int length) throws IOException {
    if (inflater != null) {
      return inflate(offset, target, length);
    }
    int there = (int) Math.max(0, Math.min(length, compressedBytes - offset));
    ByteBuffer buffer = ByteBuffer.wrap(target, 0, there).slice();
    file.read(buffer, start + offset);
    return buffer.limit();
  }

  private int inflate(long offset, byte[] target, int length) throws IOException {
    if (offset < at) {
      inflater.reset();
      piece.limit(0);
      compressedAt = 0;
      at = 0;
    }
    byte[] skipped = offset > at ? new byte[PIECE] : null;
    while (at < offset) {
      int count = inflate(skipped, 0, (int) Math.min(PIECE, offset - at));
      if (count == 0) {
        return 0;
      }
    }
    int done = 0;
    while (done < length) {
      int count = inflate(target, done, length - done);
      if (count == 0) {
        break;
      }
      done += count;
    }
    return done;
  }

  /** Decompresses some bytes; none at the end or after damage. */
  private int inflate(byte[] target, int from, int length) throws IOException {
    try {
      while (true) {
        int count = inflater.inflate(target, from, length);
        at += count;
        if (count > 0 || inflater.finished() || inflater.needsDictionary()) {
          return count;
        }
        int next = (int) Math.min(PIECE, compressedBytes - compressedAt);
        if (next <= 0) {
          return 0;
        }
        ByteBuffer buffer = ByteBuffer.wrap(piece.array(), 0, next).slice();
        file.read(buffer, start + compressedAt);
        if (!buffer.hasRemaining()) {
          return 0;
        }
        compressedAt += buffer.limit();
        inflater.setInput(piece.array(), 0, buffer.limit());
      }
    } catch (DataFormatException damaged) {
      compressedAt = compressedBytes;
      return 0;
    }
  }

  void close() {
    if (inflater != null) {
      inflater.end();
    }
  }
}
