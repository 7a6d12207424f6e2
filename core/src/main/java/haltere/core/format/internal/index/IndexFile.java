package haltere.core.format.internal.index;

import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingFile;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.CRC32;

/**
 * The index of a recording, stored in a file beside it: the content of {@link TimeIndex}, with the
 * properties of the recording for validation (size, time of change, digest of its start and end,
 * way of reading). It ends in a checksum, without which it is ignored.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class IndexFile {
  /** Suffix appended to the name of the recording. */
  static final String ENDING = ".haltere-index";

  /** Changes with the layout of the file and of the state of cursors. */
  private static final long MAGIC = 0x48616c_7465726502L;

  private static final int DIGEST_BYTES = 64 * 1024;
  private static final long MAX_BYTES = 256 << 20;

  private IndexFile() {}

  /** Path of the index of a recording. */
  static Path beside(Path recording) {
    return recording.resolveSibling(recording.getFileName() + ENDING);
  }

  /**
   * Identity of a recording and of the options of reading it.
   *
   * @param file the recording
   * @param reading format, sensor and stream as text
   */
  static byte[] identity(RecordingFile file, String reading) throws IOException {
    MessageDigest digest;
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException impossible) {
      throw new IllegalStateException(impossible);
    }
    long changedMs = Files.getLastModifiedTime(file.path()).toMillis();
    digest.update(reading.getBytes(StandardCharsets.UTF_8));
    digest.update(ByteBuffer.allocate(16).putLong(file.size()).putLong(changedMs).array());
    digest.update(file.read(0, DIGEST_BYTES));
    digest.update(file.read(Math.max(0, file.size() - DIGEST_BYTES), DIGEST_BYTES));
    return digest.digest();
  }

  /**
   * Writes an index and replaces an older one.
   *
   * @throws IOException if it cannot be written
   */
  static void write(Path recording, byte[] identity, TimeIndex index) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeLong(MAGIC);
      out.write(identity);
      index.write(out);
    }
    CRC32 crc = new CRC32();
    crc.update(bytes.toByteArray());
    try (AtomicFile file = AtomicFile.create(beside(recording), true)) {
      try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(file.stream()))) {
        bytes.writeTo(out);
        out.writeLong(crc.getValue());
        out.flush();
        file.commit();
      }
    }
  }

  /**
   * Reads an index.
   *
   * @param stateLongs number of state values of a cursor of the recording
   * @return empty if it is damaged, or of another recording or other options
   * @throws IOException if there is none, or it cannot be read
   */
  static Optional<TimeIndex> read(Path recording, byte[] identity, int stateLongs)
      throws IOException {
    Path path = beside(recording);
    if (Files.size(path) > MAX_BYTES) {
      return Optional.empty();
    }
    byte[] bytes;
    try (BufferedInputStream in = new BufferedInputStream(Files.newInputStream(path))) {
      bytes = in.readAllBytes();
    }
    int end = bytes.length - Long.BYTES;
    if (end < Long.BYTES + identity.length) {
      return Optional.empty();
    }
    CRC32 crc = new CRC32();
    crc.update(bytes, 0, end);
    ByteBuffer numbers = ByteBuffer.wrap(bytes);
    boolean fits =
        numbers.getLong(end) == crc.getValue()
            && numbers.getLong(0) == MAGIC
            && Arrays.equals(bytes, 8, 8 + identity.length, identity, 0, identity.length);
    if (!fits) {
      return Optional.empty();
    }
    int start = Long.BYTES + identity.length;
    try (DataInputStream in =
        new DataInputStream(new ByteArrayInputStream(bytes, start, end - start))) {
      return TimeIndex.read(in, stateLongs);
    }
  }
}
