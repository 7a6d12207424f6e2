package haltere.core.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The start and the end of a file, read once to detect its format. The arrays are shared and must
 * not be changed.
 *
 * @param path the file
 * @param head its first bytes, at most {@link #HEAD_BYTES}
 * @param tail its last bytes, at most {@link #TAIL_BYTES}
 * @param size bytes in the file
 * @since 0.1
 */
public record FileHead(Path path, byte[] head, byte[] tail, long size) {
  /** Length of the head in bytes. */
  public static final int HEAD_BYTES = 64 * 1024;

  /** Length of the tail in bytes. */
  public static final int TAIL_BYTES = 4 * 1024;

  /**
   * Reads head and tail of a file.
   *
   * @param path a readable file
   * @return its head
   * @throws IOException if it cannot be read
   */
  public static FileHead read(Path path) throws IOException {
    try (RecordingFile file = new RecordingFile(path)) {
      return of(file);
    }
  }

  /** Head of an open file; the tail of a stream that continues after the head is empty. */
  static FileHead of(RecordingFile file) throws IOException {
    byte[] head = file.read(0, HEAD_BYTES);
    long size = file.size();
    byte[] tail =
        size == Long.MAX_VALUE
            ? new byte[0]
            : file.read(Math.max(0, size - TAIL_BYTES), TAIL_BYTES);
    return new FileHead(file.path(), head, tail, size);
  }

  /**
   * Whether the file starts with a text.
   *
   * @param text ASCII
   * @return true if it does
   */
  public boolean startsWith(String text) {
    byte[] wanted = text.getBytes(StandardCharsets.ISO_8859_1);
    return head.length >= wanted.length
        && java.util.Arrays.equals(head, 0, wanted.length, wanted, 0, wanted.length);
  }

  /**
   * The ending of the file's name.
   *
   * @return lower case, without the dot; empty if there is none
   */
  public String extension() {
    return extension(path);
  }

  static String extension(Path path) {
    String name = path.getFileName() == null ? "" : path.getFileName().toString();
    int dot = name.lastIndexOf('.');
    return dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
  }
}
