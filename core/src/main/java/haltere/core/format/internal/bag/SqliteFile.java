package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The pages of an SQLite 3 file, to read tables from. Numbers are big-endian.
 *
 * <p>Reason for an own reader: a library would need native code for each machine, returns only
 * whole messages, and rejects damaged files that are partly readable.
 *
 * <p>Thread rule: one thread.
 */
final class SqliteFile {
  /** Signature of a file. */
  static final String MAGIC = "SQLite format 3\0";

  private static final int HEADER_BYTES = 100;

  private final RecordingFile file;
  private final int pageBytes;
  private final int usableBytes;
  private final boolean cutOff;

  SqliteFile(RecordingFile file) throws IOException {
    this.file = file;
    byte[] header = file.read(0, HEADER_BYTES);
    String magic =
        new String(header, 0, Math.min(header.length, MAGIC.length()), StandardCharsets.ISO_8859_1);
    if (header.length < HEADER_BYTES || !magic.equals(MAGIC)) {
      throw new RecordingProblem(
          file.path(), "it does not start with the signature of SQLite; leave out --format");
    }
    ByteBuffer numbers = ByteBuffer.wrap(header);
    int size = numbers.getShort(16) & 0xffff;
    pageBytes = size == 1 ? 1 << 16 : size;
    usableBytes = pageBytes - (header[20] & 0xff);
    if (Integer.bitCount(pageBytes) != 1 || pageBytes < 512 || usableBytes < 480) {
      throw new RecordingProblem(file.path(), 16, "its pages have an impossible size");
    }
    // programs before 2010 did not store the page count, as the number at 92 shows
    boolean counted = numbers.getInt(24) == numbers.getInt(92);
    long pages = counted ? numbers.getInt(28) & 0xffff_ffffL : 0;
    cutOff = file.size() % pageBytes != 0 || pages * pageBytes > file.size();
    if (numbers.getInt(56) > 1) {
      throw new RecordingProblem(file.path(), 56, "its texts are not UTF-8, as those of bags are");
    }
  }

  /** Whether pages are missing at the end. */
  boolean cutOff() {
    return cutOff;
  }

  int pageBytes() {
    return pageBytes;
  }

  /** Usable bytes of a page. */
  int usableBytes() {
    return usableBytes;
  }

  long bytes() {
    return file.size();
  }

  /** A buffer for a page. */
  ByteBuffer page() {
    return ByteBuffer.allocate(pageBytes).limit(0);
  }

  /** Reads a page; they are numbered from 1. */
  void read(ByteBuffer page, long number) throws IOException, DamagedPacketException {
    if (number < 1 || number > file.size() / pageBytes) {
      page.limit(0);
      throw new DamagedPacketException("a page outside of the file");
    }
    file.read(page, (number - 1) * pageBytes);
    if (page.limit() < pageBytes) {
      throw new DamagedPacketException("a page that ends too early");
    }
  }
}
