package haltere.core.format.internal.npz;

import haltere.core.format.RecordingFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The entries of a zip file: from its directory or, in a truncated file, from the headers of the
 * entries. Several entries can then be read in parallel, which {@code java.util.zip} does not
 * support for such files.
 */
final class ZipDirectory {
  private static final int LOCAL = 0x04034b50;
  private static final int CENTRAL = 0x02014b50;
  private static final int END = 0x06054b50;
  private static final int END_64 = 0x06064b50;
  private static final int LOCATOR_64 = 0x07064b50;
  private static final int LOCAL_BYTES = 30;
  private static final int CENTRAL_BYTES = 46;
  private static final int END_BYTES = 22;
  private static final int MAX_TAIL = 0xffff + END_BYTES;
  private static final int MAX_DIRECTORY = 1 << 20;
  private static final int MAX_ENTRIES = 1000;
  private static final long UNSIGNED = 0xffffffffL;

  /**
   * An entry.
   *
   * @param name its name
   * @param method 0 stored, 8 deflated
   * @param offset start of its bytes
   * @param compressedBytes their number, within the file
   * @param whole whether the file has all of them
   */
  record ZipMember(String name, int method, long offset, long compressedBytes, boolean whole) {}

  private ZipDirectory() {}

  /** The entries in the directory of a file; empty if there is no directory. */
  static Optional<List<ZipMember>> of(RecordingFile file) throws IOException {
    return listed(file);
  }

  /** The entries that can be found without a directory. */
  static List<ZipMember> withoutDirectory(RecordingFile file) throws IOException {
    return found(file);
  }

  private static ByteBuffer bytes(RecordingFile file, long offset, int length) throws IOException {
    return ByteBuffer.wrap(file.read(Math.max(0, offset), length)).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static Optional<List<ZipMember>> listed(RecordingFile file) throws IOException {
    long tailOffset = Math.max(0, file.size() - MAX_TAIL);
    ByteBuffer tail = bytes(file, tailOffset, MAX_TAIL);
    for (int at = tail.limit() - END_BYTES; at >= 0; at--) {
      if (tail.getInt(at) != END) {
        continue;
      }
      long length = tail.getInt(at + 12) & UNSIGNED;
      long offset = tail.getInt(at + 16) & UNSIGNED;
      if (at >= 20 && tail.getInt(at - 20) == LOCATOR_64) {
        ByteBuffer wide = bytes(file, tail.getLong(at - 12), 56);
        if (wide.limit() == 56 && wide.getInt(0) == END_64) {
          length = wide.getLong(40);
          offset = wide.getLong(48);
        }
      }
      if (offset < 0 || length < 0 || length > MAX_DIRECTORY || offset > file.size() - length) {
        continue;
      }
      return entries(file, bytes(file, offset, (int) length));
    }
    return Optional.empty();
  }

  private static Optional<List<ZipMember>> entries(RecordingFile file, ByteBuffer directory)
      throws IOException {
    List<ZipMember> entries = new ArrayList<>();
    int at = 0;
    while (at + CENTRAL_BYTES <= directory.limit() && entries.size() < MAX_ENTRIES) {
      int nameBytes = directory.getShort(at + 28) & 0xffff;
      int extraBytes = directory.getShort(at + 30) & 0xffff;
      int end =
          at + CENTRAL_BYTES + nameBytes + extraBytes + (directory.getShort(at + 32) & 0xffff);
      if (directory.getInt(at) != CENTRAL || end > directory.limit()) {
        return Optional.empty();
      }
      long[] sizes = {
        directory.getInt(at + 24) & UNSIGNED,
        directory.getInt(at + 20) & UNSIGNED,
        directory.getInt(at + 42) & UNSIGNED
      };
      widen(directory, at + CENTRAL_BYTES + nameBytes, extraBytes, sizes);
      ByteBuffer local = bytes(file, sizes[2], LOCAL_BYTES);
      if (local.limit() < LOCAL_BYTES || local.getInt(0) != LOCAL) {
        return Optional.empty();
      }
      long start =
          sizes[2] + LOCAL_BYTES + (local.getShort(26) & 0xffff) + (local.getShort(28) & 0xffff);
      entries.add(
          entry(
              file,
              name(directory, at + CENTRAL_BYTES, nameBytes),
              directory.getShort(at + 10),
              start,
              sizes[1]));
      at = end;
    }
    return Optional.of(entries);
  }

  /** Reads sizes and offsets beyond 32 bits from an extra field, in this order. */
  private static void widen(ByteBuffer bytes, int from, int length, long[] sizes) {
    int at = from;
    while (at + 4 <= from + length) {
      int fieldBytes = bytes.getShort(at + 2) & 0xffff;
      if (bytes.getShort(at) == 1) {
        int value = at + 4;
        for (int i = 0; i < sizes.length; i++) {
          if (sizes[i] == UNSIGNED && value + 8 <= Math.min(at + 4 + fieldBytes, from + length)) {
            sizes[i] = bytes.getLong(value);
            value += 8;
          }
        }
      }
      at += 4 + fieldBytes;
    }
  }

  private static String name(ByteBuffer bytes, int at, int length) {
    return new String(bytes.array(), at, length, StandardCharsets.UTF_8);
  }

  private static ZipMember entry(
      RecordingFile file, String name, int method, long start, long compressed) {
    long rest = Math.max(0, file.size() - start);
    boolean whole = compressed >= 0 && compressed <= rest;
    return new ZipMember(name, method, start, whole ? compressed : rest, whole);
  }

  /** Sequential entries, as far as their sizes are stated. */
  private static List<ZipMember> found(RecordingFile file) throws IOException {
    List<ZipMember> entries = new ArrayList<>();
    long offset = 0;
    while (entries.size() < MAX_ENTRIES) {
      ByteBuffer local = bytes(file, offset, LOCAL_BYTES + 0x1ffff);
      if (local.limit() < LOCAL_BYTES || local.getInt(0) != LOCAL) {
        break;
      }
      int nameBytes = local.getShort(26) & 0xffff;
      int extraBytes = local.getShort(28) & 0xffff;
      if (LOCAL_BYTES + nameBytes + extraBytes > local.limit()) {
        break;
      }
      long[] sizes = {local.getInt(22) & UNSIGNED, local.getInt(18) & UNSIGNED};
      widen(local, LOCAL_BYTES + nameBytes, extraBytes, sizes);
      long start = offset + LOCAL_BYTES + nameBytes + extraBytes;
      boolean later = (local.getShort(6) & 8) != 0 && sizes[1] == 0;
      ZipMember entry =
          entry(
              file,
              name(local, LOCAL_BYTES, nameBytes),
              local.getShort(8),
              start,
              later ? Long.MAX_VALUE : sizes[1]);
      entries.add(entry);
      if (!entry.whole()) {
        break;
      }
      offset = start + entry.compressedBytes();
    }
    return entries;
  }
}
