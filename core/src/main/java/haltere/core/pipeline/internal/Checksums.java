package haltere.core.pipeline.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;

/**
 * SHA-256 of files and texts, as hexadecimal digits.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class Checksums {
  private static final int BUFFER_BYTES = 1 << 20;

  private Checksums() {}

  private static MessageDigest digest() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException impossible) {
      throw new IllegalStateException(impossible);
    }
  }

  /**
   * The SHA-256 of bytes.
   *
   * @param bytes any
   * @return 32 bytes
   */
  public static byte[] sha256(byte[] bytes) {
    return digest().digest(bytes);
  }

  /**
   * The SHA-256 of a text in UTF-8.
   *
   * @param text any
   * @return 64 digits
   */
  public static String ofText(String text) {
    return HexFormat.of().formatHex(sha256(text.getBytes(StandardCharsets.UTF_8)));
  }

  /**
   * The SHA-256 of a recording.
   *
   * @param path a file; of a folder, the names and contents of its files in the order of their
   *     names count
   * @return 64 digits
   * @throws IOException if it cannot be read
   */
  public static String of(Path path) throws IOException {
    MessageDigest digest = digest();
    if (Files.isDirectory(path)) {
      for (Path file : files(path)) {
        digest.update(path.relativize(file).toString().getBytes(StandardCharsets.UTF_8));
        digest.update((byte) 0);
        add(digest, file);
      }
    } else {
      add(digest, path);
    }
    return HexFormat.of().formatHex(digest.digest());
  }

  /**
   * All files of a folder and the folders in it.
   *
   * @param folder a folder
   * @return in the order of their names
   * @throws IOException if it cannot be read
   */
  public static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile).sorted().toList();
    } catch (UncheckedIOException unreadable) {
      throw unreadable.getCause();
    }
  }

  private static void add(MessageDigest digest, Path file) throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES);
    try (FileChannel channel = FileChannel.open(file)) {
      while (channel.read(buffer) >= 0) {
        digest.update(buffer.flip());
        buffer.clear();
      }
    }
  }
}
